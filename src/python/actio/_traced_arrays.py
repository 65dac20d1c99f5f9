"""Arrays of traced numbers: NumPy's arrays of objects, on which its functions are those of a formula."""

import difflib
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy

from actio._formula_functions import FUNCTIONS
from actio._refusals import refuse, refuse_branch, refuse_corner
from actio._traced import Traced, recorded
from actio._values import shown


def _function(name: str) -> Any:
    def apply_to(*arguments: Any) -> Any:
        if any(isinstance(each, Traced) for each in arguments):
            return recorded(name, arguments)
        return getattr(numpy, FUNCTIONS[name][0])(*arguments)

    return apply_to


_sinh, _exp, _atanh = _function("sinh"), _function("exp"), _function("atanh")

# What NumPy's functions of numbers are on traced ones.
_SMOOTH: dict[str, Any] = {
    "add": lambda x, y: x + y,
    "subtract": lambda x, y: x - y,
    "multiply": lambda x, y: x * y,
    "divide": lambda x, y: x / y,
    "power": lambda x, y: x**y,
    "float_power": lambda x, y: x**y,
    "negative": lambda x: -x,
    "positive": lambda x: x,
    "conjugate": lambda x: x,
    "square": lambda x: x**2,
    "reciprocal": lambda x: 1 / x,
    "exp2": lambda x: 2**x,
    "expm1": lambda x: 2 * _exp(x / 2) * _sinh(x / 2),
    "log1p": lambda x: 2 * _atanh(x / (2 + x)),
    "deg2rad": lambda x: x * (math.pi / 180),
    "radians": lambda x: x * (math.pi / 180),
    "rad2deg": lambda x: x * (180 / math.pi),
    "degrees": lambda x: x * (180 / math.pi),
    **{numpys: _function(name) for name, (numpys, _) in FUNCTIONS.items()},
}
_COMPARED = "greater greater_equal less less_equal equal not_equal isnan isinf isfinite signbit".split() + [
    "logical_and",
    "logical_or",
    "logical_not",
    "logical_xor",
]
_CORNERED = (
    "absolute fabs sign maximum minimum fmax fmin clip floor ceil rint trunc heaviside remainder fmod"
    " floor_divide divmod modf copysign"
).split()


def _plain(value: Any) -> Any:
    """The same as an array of objects that NumPy does not hand back to us."""
    if isinstance(value, Traced):
        held = numpy.empty((), object)
        held[()] = value
        return held
    return numpy.asarray(value) if isinstance(value, TracedArray) else value


def _wrapped(value: Any) -> Any:
    """An array of objects as one of traced numbers."""
    if isinstance(value, numpy.ndarray) and value.dtype == object:
        return value.view(TracedArray)
    return tuple(_wrapped(each) for each in value) if isinstance(value, tuple) else value


def on_items(name: str, arguments: Sequence[Any]) -> Any:
    """A function of a formula at numbers or arrays, item by item."""
    function = getattr(numpy, FUNCTIONS[name][0])
    held = [numpy.array(each) if isinstance(each, (list, tuple)) else each for each in arguments]
    if any(isinstance(each, Traced) or getattr(each, "dtype", None) == object for each in held):
        return apply(function, "__call__", held, {})
    return function(*held)


def apply(ufunc: Any, method: str, inputs: Sequence[Any], options: Mapping[str, Any]) -> Any:
    """A function of NumPy where an argument is traced."""
    name = ufunc.__name__
    if name in _COMPARED:
        refuse_branch(f"numpy.{name} asks for the values of numbers")
    if name in _CORNERED:
        refuse_corner(f"numpy.{name}")
    plain = [_plain(value) for value in inputs]
    out = options.get("out")
    if method == "__call__" and name in _SMOOTH:
        ufunc = numpy.frompyfunc(_SMOOTH[name], len(inputs), 1)
        options = {key: value for key, value in options.items() if key in ("out", "where")}
    elif name not in _SMOOTH and ufunc is not numpy.matmul:
        refuse(f"numpy.{name} is no function of a formula, which has {', '.join(FUNCTIONS)}")
    if out is None:
        return _wrapped(getattr(ufunc, method)(*plain, **options))
    getattr(ufunc, method)(*plain, **{**options, "out": tuple(_plain(each) for each in out)})
    return out[0] if len(out) == 1 else out


class TracedArray(numpy.ndarray):  # type: ignore[type-arg]
    """An array of traced numbers."""

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return apply(ufunc, method, inputs, options)


def traced_array(items: Sequence[Any]) -> TracedArray:
    """The numbers as an array, which cannot be written to."""
    held = numpy.empty(len(items), object)
    held[:] = items
    held.flags.writeable = False
    return held.view(TracedArray)


class Vector(TracedArray):
    """The velocity: its components are items, `xi[0]`, and have names, `xi.w1`; `xi.matrix` is its matrix."""

    _names: tuple[str, ...] = ()
    _basis: Any = None

    def __array_finalize__(self, other: Any) -> None:
        self._names, self._basis = (), None

    def __getattr__(self, name: str) -> Any:
        if name in self._names:
            return self[self._names.index(name)]
        if name.startswith("_"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        if not self._names:
            raise AttributeError(f"a part or a copy of the velocity has items alone, and no {name}")
        raise AttributeError(f"velocity: {_unknown('component', name, self._names)}")

    @property
    def matrix(self) -> TracedArray:
        """The element of the Lie algebra as a matrix: the sum of the components times the basis."""
        if self._basis is None:
            raise AttributeError("a part or a copy of the velocity has items alone, and no matrix")
        return numpy.tensordot(numpy.asarray(self), self._basis, 1).view(TracedArray)


def vector(items: Sequence[Any], names: Sequence[str], basis: Any) -> Vector:
    """The velocity, with the names of its components and the basis of the Lie algebra."""
    found = traced_array(items).view(Vector)
    found._names, found._basis = tuple(names), basis
    return found


def _unknown(what: str, name: str, names: Sequence[str]) -> str:
    near = difflib.get_close_matches(name, names, 1)
    hint = f"; did you mean {near[0]}?" if near else ""
    there = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    return f"there is no {what} {shown(name)}{hint}" + (f"; there is {there}" if names else "")


class Names(Mapping[str, Any]):
    """The parameters, or the carried vectors: `p.c`, or `p["c"]` where the name is no name of Python."""

    __slots__ = ("_what", "_there")

    def __init__(self, what: str, there: Mapping[str, Any]) -> None:
        self._what, self._there = what, dict(there)

    def __getitem__(self, name: str) -> Any:
        if name in self._there:
            return self._there[name]
        raise KeyError(_unknown(self._what, name, list(self._there)))

    def __getattribute__(self, name: str) -> Any:
        if not name.startswith("_") and name in (there := object.__getattribute__(self, "_there")):
            return there[name]
        return object.__getattribute__(self, name)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        raise AttributeError(_unknown(self._what, name, list(self._there)))

    def __repr__(self) -> str:
        return f"<{self._what}s: {', '.join(self._there)}>"

    def __iter__(self) -> Iterator[str]:
        return iter(self._there)

    def __len__(self) -> int:
        return len(self._there)

