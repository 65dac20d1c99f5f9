"""The Lie algebra of a group: its basis of matrices, and the names of the components of a velocity."""

from collections.abc import Sequence
from typing import Any, NamedTuple, Union

import numpy
from numpy.typing import NDArray

from actio import _actio
from actio._errors import Error, SceneError
from actio._values import in_utf8, kind, shown

#: A group: its name, or a basis of its Lie algebra, a sequence of square matrices.
Group = Union[str, Sequence[Any], NDArray[Any]]


class Algebra(NamedTuple):
    """The Lie algebra of a group."""

    name: str  #: of the group; empty where a basis was given
    components: tuple[str, ...]
    basis: NDArray[numpy.float64]  #: dimension by n by n


def _matrices(group: Any) -> NDArray[numpy.float64]:
    """The basis as an array, dimension by n by n."""
    try:
        matrices = [numpy.asarray(matrix) for matrix in group]
    except TypeError:
        raise TypeError(
            f'group: a name such as "SE(2)" or a list of matrices is expected, found {shown(group)}, of type'
            f" {kind(group)}"
        ) from None
    if not matrices:
        raise SceneError("group: the list of matrices is empty")
    for number, matrix in enumerate(matrices, 1):
        if matrix.dtype.kind not in "biuf":
            found = "complex" if matrix.dtype.kind == "c" else shown(matrix.tolist())
            raise TypeError(f"group: a matrix of real numbers is expected, matrix {number} is {found}")
        if matrix.ndim != 2 or matrix.shape != (len(matrices[0]),) * 2 or not matrix.size:
            raise SceneError(
                "group: square matrices of one size are expected, matrix"
                f" {number} is {' by '.join(map(str, matrix.shape)) or 'a number'}"
            )
        if not numpy.isfinite(matrix).all():
            raise SceneError(f"group: finite numbers are expected, matrix {number} has others")
    return numpy.array(matrices, dtype=float)


def algebra_of(group: Any) -> Algebra:
    """The Lie algebra of a group.

    group: its name, or a basis of the algebra.

    Raises SceneError where no group has that name; where the matrices are not independent, or a commutator
    of two of them leaves their span.
    """
    try:
        if isinstance(group, str):
            found = _actio.named_algebra(in_utf8(group, "group"))
        else:
            found = _actio.spanned_algebra(_matrices(group))
    except SceneError:
        raise
    except Error as error:
        message = str(error)
        raise SceneError(message if message.startswith("group") else f"group: {message}") from None
    # No zero has a sign in a scene.
    return Algebra(found["name"], tuple(found["components"]), found["basis"] + 0.0)
