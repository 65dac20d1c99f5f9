"""The Lie algebra of a group: its basis of matrices, and the names of the components of a velocity."""

from collections.abc import Sequence
from typing import Any, NamedTuple, Union

import numpy
from numpy.typing import NDArray

from actio._errors import SceneError
from actio._values import kind, shown

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


_COMPONENTS = {"SO(3)": "w1 w2 w3", "SE(2)": "w v1 v2", "SE(3)": "w1 w2 w3 v1 v2 v3"}


def algebra_of(group: Any) -> Algebra:
    """The Lie algebra of a group.

    group: its name, or a basis of the algebra.
    """
    if isinstance(group, str):
        if group not in _COMPONENTS:
            raise SceneError(f"group: {', '.join(_COMPONENTS)} are expected, found {shown(group)}")
        components = tuple(_COMPONENTS[group].split())
        return Algebra(group, components, _basis(group))
    matrices = _matrices(group)
    return Algebra("", tuple(f"x{k + 1}" for k in range(len(matrices))), matrices)


def _basis(group: str) -> NDArray[numpy.float64]:
    """Rotations e_i with e_i x = e_i cross x, then translations."""
    size = int(group[3])
    rows = size if group[1] == "O" else size + 1
    turns = [(1, 0)] if size == 2 else [(2, 1), (0, 2), (1, 0)]
    entries = [[(i, j, 1), (j, i, -1)] for i, j in turns]
    entries += [[(i, size, 1)] for i in range(size)] if rows > size else []
    basis = numpy.zeros((len(entries), rows, rows))
    for matrix, own in zip(basis, entries):
        for i, j, value in own:
            matrix[i, j] = value
    return basis
