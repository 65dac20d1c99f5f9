"""Moments of mass of a body."""

import math
import numbers
from typing import Any

import numpy
from numpy.typing import NDArray

from actio import _actio
from actio._errors import Error, FileError, SceneError
from actio._paths import Path, encoded_path
from actio._values import kind, shown

_HIGHEST = 16


def _positive(value: Any, what: str) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{what}: a number is expected, found {shown(value)}, of type {kind(value)}")
    if not (value > 0 and math.isfinite(value)):
        raise SceneError(f"{what}: a number > 0 is expected, found {shown(value)}")
    return float(value)


def moments(
    mesh: Path, order: int = 2, *, density: float = 1.0, length_unit: float = 1.0
) -> NDArray[numpy.float64]:
    """The moments of mass of a homogeneous body, from its surface:

        A_ijl = integral of density x^i y^j z^l over the body, for i + j + l <= order,

    about the origin of the file and along its axes.

    mesh: the path of a file in the format .obj with a closed surface, its faces counter-clockwise as seen
    from outside.

    order: the largest i + j + l, from 0 to 16.

    density: mass per volume.

    length_unit: what a length of 1 in the file is.

    Returns an array with a row i, j, l, A_ijl for each of them, by increasing order, as `moments` in
    [system.primary] and [system.secondary] of a scene of two bodies takes it. The first is the mass; the
    unit of A_ijl is mass times length^(i + j + l).

    They are the sums over the tetrahedra between the origin and the triangles of the surface of

        6 V n!/(n + 3)! h_n(p.s, q.s, w.s),

    the integral of (s.x)^n over the one with the corners 0, p, q, w and the volume V, where h_n is the
    complete symmetric polynomial of degree n = i + j + l: a formula without an error of its own. Rounding is
    that of the sum, relative to the moments of the tetrahedra.

        moon = actio.moments("moon.obj", 4, density=2400, length_unit=1000)
        mass = moon[0, 3]
        centre = moon[1:4, 3] / mass
        actio.run("kw4", set={"system.secondary": {"moments": moon, "radius": 300}})

    Raises FileError where the file cannot be read; SceneError where a number is out of its range; Error
    where the file is none in the format, with its line, and where the surface is not closed or inside out.
    """
    path = encoded_path(mesh, "mesh")
    if isinstance(order, bool) or not isinstance(order, numbers.Integral):
        raise TypeError(
            f"order: a whole number is expected, found {shown(order)}, of type {kind(order)}"
        )
    if not 0 <= order <= _HIGHEST:
        raise SceneError(f"order: a whole number from 0 to {_HIGHEST} is expected, found {shown(order)}")
    density, length_unit = _positive(density, "density"), _positive(length_unit, "length_unit")
    try:
        with open(path, "rb") as file:
            text = file.read()
    except OSError as error:
        raise FileError(f"mesh: {shown(mesh)} cannot be read: {error.strerror}") from None
    try:
        return _actio.moments(text, int(order), density, length_unit)
    except Error as error:
        raise Error(f"mesh: {shown(mesh)}: {error}") from None
