"""The functions of a formula: of numbers, of arrays item by item, and of what a Lagrangian is given.

Those of NumPy do as well. Those of the module math do not: they need a float.
"""

import math
import numbers
from typing import Any

import numpy

from actio._traced import Traced
from actio._traced_arrays import on_items
from actio._values import kind, shown


def _applied(name: str, *arguments: Any) -> Any:
    """The function at numbers, traced or not, or at arrays of them."""
    if any(isinstance(each, (numpy.ndarray, list, tuple)) for each in arguments):
        return on_items(name, arguments)
    if any(isinstance(each, Traced) for each in arguments):
        return on_items(name, arguments)
    for each in arguments:
        if not isinstance(each, numbers.Real):
            raise TypeError(f"{name}: a number is expected, found {shown(each)}, of type {kind(each)}")
    # math has had no cube root before Python 3.11.
    return float(numpy.cbrt(*arguments)) if name == "cbrt" else getattr(math, name)(*arguments)


def sin(x: Any) -> Any:
    """The sine of an angle in radians."""
    return _applied("sin", x)


def cos(x: Any) -> Any:
    """The cosine of an angle in radians."""
    return _applied("cos", x)


def tan(x: Any) -> Any:
    """The tangent of an angle in radians."""
    return _applied("tan", x)


def asin(x: Any) -> Any:
    """The angle from -pi/2 to pi/2 whose sine is x."""
    return _applied("asin", x)


def acos(x: Any) -> Any:
    """The angle from 0 to pi whose cosine is x."""
    return _applied("acos", x)


def atan(x: Any) -> Any:
    """The angle from -pi/2 to pi/2 whose tangent is x."""
    return _applied("atan", x)


def atan2(y: Any, x: Any) -> Any:
    """The angle, from -pi to pi, of the point (x, y) of the plane."""
    return _applied("atan2", y, x)


def sinh(x: Any) -> Any:
    """The hyperbolic sine."""
    return _applied("sinh", x)


def cosh(x: Any) -> Any:
    """The hyperbolic cosine."""
    return _applied("cosh", x)


def tanh(x: Any) -> Any:
    """The hyperbolic tangent."""
    return _applied("tanh", x)


def asinh(x: Any) -> Any:
    """The number whose hyperbolic sine is x."""
    return _applied("asinh", x)


def acosh(x: Any) -> Any:
    """The number, not below zero, whose hyperbolic cosine is x."""
    return _applied("acosh", x)


def atanh(x: Any) -> Any:
    """The number whose hyperbolic tangent is x."""
    return _applied("atanh", x)


def exp(x: Any) -> Any:
    """The exponential."""
    return _applied("exp", x)


def log(x: Any) -> Any:
    """The natural logarithm."""
    return _applied("log", x)


def log2(x: Any) -> Any:
    """The logarithm to base 2."""
    return _applied("log2", x)


def log10(x: Any) -> Any:
    """The logarithm to base 10."""
    return _applied("log10", x)


def sqrt(x: Any) -> Any:
    """The square root."""
    return _applied("sqrt", x)


def cbrt(x: Any) -> Any:
    """The cube root."""
    return _applied("cbrt", x)


def hypot(x: Any, y: Any) -> Any:
    """The length of the vector (x, y)."""
    return _applied("hypot", x, y)
