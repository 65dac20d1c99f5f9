"""Numbers that stand for what is not known yet, and record what is done with them.

A Lagrangian that is a function of Python is called once, with such numbers in place of velocity, parameters
and carried vectors. What comes back names the entry of the table that is the Lagrangian; `_formula_text`
writes it as a formula, and Python has no part in the run.
"""

import numbers
from collections.abc import Callable, Mapping
from typing import Any

from actio._formula_functions import FUNCTIONS
from actio._refusals import refuse, refuse_branch, refuse_corner, refuse_float, refuse_whole
from actio._trace import Trace, constant
from actio._values import kind, shown


class Traced:
    """A number that is traced: it has no value, and records what is done with it."""

    __slots__ = ("_trace", "_index")
    __hash__ = object.__hash__

    def __init__(self, trace: Trace, index: int) -> None:
        self._trace, self._index = trace, index

    def _taken(self, other: Any) -> Any:
        """The entry of the other operand; None where it is no number."""
        if isinstance(other, Traced):
            if other._trace is not self._trace:
                refuse(
                    "numbers of two calls are mixed; a Lagrangian uses the numbers that it is given by this"
                    " very call, and keeps none of an earlier one"
                )
            return other._index
        if isinstance(other, numbers.Complex) and not isinstance(other, numbers.Real):
            refuse(f"a Lagrangian is real, found the complex number {shown(other)}")
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
        from actio._traced_arrays import apply

        return apply(ufunc, method, inputs, options)

    # ---- What needs a value, which it has not

    def __bool__(self) -> bool:
        refuse_branch("whether a number is true is asked")

    def __lt__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by <")

    def __le__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by <=")

    def __gt__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by >")

    def __ge__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by >=")

    def __eq__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by ==")

    def __ne__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by !=")

    def __float__(self) -> float:
        refuse_float()

    def __complex__(self) -> complex:
        refuse("a complex number is needed here, and a Lagrangian is real")

    def __index__(self) -> int:
        refuse_whole()

    __int__ = __index__

    # ---- What is not smooth

    def __abs__(self) -> "Traced":
        refuse_corner("abs")

    def __round__(self, digits: Any = None) -> "Traced":
        refuse_corner("round")

    def __floor__(self) -> "Traced":
        refuse_corner("floor")

    def __ceil__(self) -> "Traced":
        refuse_corner("ceil")

    def __trunc__(self) -> "Traced":
        refuse_corner("trunc")

    def __floordiv__(self, other: Any) -> "Traced":
        refuse_corner("//")

    __rfloordiv__ = __floordiv__

    def __mod__(self, other: Any) -> "Traced":
        refuse_corner("%")

    __rmod__ = __mod__

    def __divmod__(self, other: Any) -> "Traced":
        refuse_corner("divmod")

    __rdivmod__ = __divmod__

    def __repr__(self) -> str:
        from actio._formula_text import formula_text

        return f"<traced number {shown(formula_text(self))[1:-1]}>"

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
