"""Numbers that stand for what is not known yet, and record what is done with them.

A Lagrangian that is a function of Python is called once, with such numbers in place of velocity, parameters
and carried vectors. What comes back names the entry of the table that is the Lagrangian; `_formula_text`
writes it as a formula, and Python has no part in the run. Arrays of them are NumPy's arrays of objects, on
which its functions are those of a formula.
"""

import math
import numbers
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy

from actio._formula_functions import FUNCTIONS, KINKED
from actio._formula_text import formula_text
from actio._refusals import refuse, refuse_branch, refuse_corner, subject
from actio._trace import Trace, constant
from actio._values import kind, shown
from actio._without_value import WithoutValue


class Traced(WithoutValue):
    """A number that is traced: it has no value, and records what is done with it."""

    __slots__ = ("_trace", "_index")

    def __init__(self, trace: Trace, index: int) -> None:
        self._trace, self._index = trace, index

    def _taken(self, other: Any) -> Any:
        """The entry of the other operand; None where it is no number."""
        if isinstance(other, Traced):
            if other._trace is not self._trace:
                refuse(
                    f"numbers of two calls are mixed; {subject().words} uses the numbers that it is given by"
                    " this very call, and keeps none of an earlier one"
                )
            return other._index
        if isinstance(other, numbers.Complex) and not isinstance(other, numbers.Real):
            refuse(f"{subject().words} is real, found the complex number {shown(other)}")
        if isinstance(other, (str, bytes, list, tuple, Mapping)):
            refuse(f"a number or an array of NumPy is expected, found {shown(other)}, of type {kind(other)}")
        value = constant(other)
        return None if value is None else self._trace.number(value)

    def _with(self, operation: Callable[[Trace, int, int], int], other: Any, swapped: bool = False) -> Any:
        taken = self._taken(other)
        if taken is None:
            return NotImplemented
        first, second = (taken, self._index) if swapped else (self._index, taken)
        return Traced(self._trace, operation(self._trace, first, second))

    # ---- What makes a formula

    def __add__(self, other: Any) -> Any:
        return self._with(Trace.sum, other)

    def __radd__(self, other: Any) -> Any:
        return self._with(Trace.sum, other, True)

    def __sub__(self, other: Any) -> Any:
        return self._with(Trace.difference, other)

    def __rsub__(self, other: Any) -> Any:
        return self._with(Trace.difference, other, True)

    def __mul__(self, other: Any) -> Any:
        return self._with(Trace.product, other)

    def __rmul__(self, other: Any) -> Any:
        return self._with(Trace.product, other, True)

    def __truediv__(self, other: Any) -> Any:
        return self._with(Trace.quotient, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._with(Trace.quotient, other, True)

    def __pow__(self, other: Any, modulus: Any = None) -> Any:
        if modulus is not None:
            refuse_corner("a power modulo a number")
        return self._with(Trace.power, other)

    def __rpow__(self, other: Any) -> Any:
        return self._with(Trace.power, other, True)

    def __neg__(self) -> "Traced":
        return Traced(self._trace, self._trace.negative(self._index))

    def __pos__(self) -> "Traced":
        return self

    def __abs__(self) -> Any:
        return abs_of(self)

    def conjugate(self) -> "Traced":
        """Itself: it is real."""
        return self

    @property
    def real(self) -> "Traced":
        """Itself: it is real."""
        return self

    def __copy__(self) -> "Traced":
        return self

    def __deepcopy__(self, memo: Any) -> "Traced":
        return self

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return apply(ufunc, method, inputs, options)

    def __repr__(self) -> str:
        return f"<traced number {shown(formula_text(self._trace, self._index))[1:-1]}>"

    def __format__(self, how: str) -> str:
        if how:
            refuse("a float is needed to be written in a format, and this number is traced: it has no value")
        return repr(self)


def recorded(name: str, arguments: tuple[Any, ...]) -> Traced:
    """A function of a formula at numbers of which one is traced."""
    first = next(each for each in arguments if isinstance(each, Traced))
    taken = [first._taken(each) for each in arguments]
    for each, found in zip(arguments, taken):
        if found is None:
            raise TypeError(f"{name}: a number is expected, found {shown(each)}, of type {kind(each)}")
    return Traced(first._trace, first._trace.add(name, *taken))


# NumPy asks the items of its arrays for methods of its own names.
for _name, (_numpys, _count) in FUNCTIONS.items():
    setattr(
        Traced, _numpys, (lambda name: lambda self, *others: recorded(name, (self, *others)))(_name)
    )


def abs_of(number: Traced) -> Traced:
    """The modulus, in a formula that is not differentiated."""
    if subject().smooth:
        refuse_corner("abs")
    return recorded("abs", (number,))


# ---- Arrays of them, and NumPy's functions


def _function(name: str) -> Any:
    def apply_to(*arguments: Any) -> Any:
        if any(isinstance(each, Traced) for each in arguments):
            return recorded(name, arguments)
        return getattr(numpy, {**FUNCTIONS, **KINKED}[name][0])(*arguments)

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
_KINKED = {numpys: _function(name) for name, (numpys, _) in KINKED.items()}
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


def apply(ufunc: Any, method: str, inputs: Sequence[Any], options: Mapping[str, Any]) -> Any:
    """A function of NumPy where an argument is traced."""
    name = ufunc.__name__
    if name in _COMPARED:
        refuse_branch(f"numpy.{name} asks for the values of numbers")
    known = _SMOOTH if subject().smooth else {**_SMOOTH, **_KINKED}
    if name in _CORNERED and name not in known:
        refuse_corner(f"numpy.{name}")
    plain = [_plain(value) for value in inputs]
    out = options.get("out")
    if method == "__call__" and name in known:
        ufunc = numpy.frompyfunc(known[name], len(inputs), 1)
        options = {key: value for key, value in options.items() if key in ("out", "where")}
    elif name not in known and ufunc is not numpy.matmul:
        refuse(f"numpy.{name} is no function of a formula, which has {', '.join(FUNCTIONS)}")
    if out is None:
        return _wrapped(getattr(ufunc, method)(*plain, **options))
    getattr(ufunc, method)(*plain, **{**options, "out": tuple(_plain(each) for each in out)})
    return out[0] if len(out) == 1 else out


class TracedArray(numpy.ndarray):  # type: ignore[type-arg]
    """An array of traced numbers."""

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return apply(ufunc, method, inputs, options)
