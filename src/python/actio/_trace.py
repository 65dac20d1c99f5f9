"""The table of what a function does with its arguments.

Each operation is an entry, a common one only once, after the entries that it takes. It is named by its
number. What computes nothing is left out: x + 0, x*1, x*0, x^1, -(-x).
"""

import math
import numbers
from typing import Any, Optional

import numpy

from actio._refusals import refuse

# As many instructions as a formula has at most.
MOST_ENTRIES = 100_000

#: An operation and the numbers of its arguments; ("symbol", its name); ("constant", its value).
Entry = tuple[Any, ...]


def constant(value: Any) -> Any:
    """A real number as the table has it: an int, a fraction as (p, q), a float; None of all else. What has no
    place in 64 bits is a float."""
    if isinstance(value, (bool, numpy.bool_)):
        return int(value)
    if isinstance(value, numbers.Rational):
        ratio = int(value.numerator), int(value.denominator)
        if max(abs(ratio[0]), ratio[1]) < 2**63:
            return ratio[0] if ratio[1] == 1 else ratio
    if not isinstance(value, numbers.Real):
        return None
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        refuse(f"a number is expected, found {number}")
    return int(number) if number.is_integer() and abs(number) < 2**53 else number


class Trace:
    """The table of one call."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self._found: dict[Entry, int] = {}

    def add(self, operation: str, *arguments: Any) -> int:
        """The entry of an operation, made where it is not there. Sums and products commute."""
        key = (operation, *(sorted(arguments) if operation in ("+", "*") else arguments))
        index = self._found.get(key)
        if index is None:
            if len(self.entries) >= MOST_ENTRIES:
                refuse(f"it takes more than {MOST_ENTRIES} operations, which no formula does")
            index = self._found[key] = len(self.entries)
            self.entries.append((operation, *arguments))
        return index

    def number(self, value: Any) -> int:
        """The entry of what `constant` gives."""
        return self.add("constant", value)

    def _is(self, index: int, value: int) -> bool:
        return self.entries[index] == ("constant", value)

    def _negated(self, index: int) -> Optional[int]:
        """x of -x, and 3 of the constant -3; None of all else."""
        operation, first, *others = self.entries[index]
        if operation == "-" and not others:
            return int(first)
        if operation != "constant" or (first[0] if isinstance(first, tuple) else first) >= 0:
            return None
        return self.number((-first[0], first[1]) if isinstance(first, tuple) else -first)

    # ---- Operations

    def negative(self, x: int) -> int:
        """-x."""
        operation, value, *_ = self.entries[x]
        if operation == "constant":
            return self.number((-value[0], value[1]) if isinstance(value, tuple) else -value)
        inner = self._negated(x)
        return self.add("-", x) if inner is None else inner

    def sum(self, x: int, y: int) -> int:
        """x + y."""
        if self._is(x, 0) or self._is(y, 0):
            return y if self._is(x, 0) else x
        inner = self._negated(y)
        return self.add("+", x, y) if inner is None else self.add("-", x, inner)

    def difference(self, x: int, y: int) -> int:
        """x - y."""
        if self._is(x, 0) or self._is(y, 0):
            return self.negative(y) if self._is(x, 0) else x
        inner = self._negated(y)
        return self.add("-", x, y) if inner is None else self.add("+", x, inner)

    def product(self, x: int, y: int) -> int:
        """x*y."""
        for one, other in ((x, y), (y, x)):
            if self._is(one, 0):
                return one
            if self._is(one, 1):
                return other
            if self._is(one, -1):
                return self.negative(other)
        return self.add("*", x, y)

    def quotient(self, x: int, y: int) -> int:
        """x/y."""
        if self._is(y, 0):
            refuse("a number is divided by zero")
        return x if self._is(x, 0) or self._is(y, 1) else self.add("/", x, y)

    def power(self, x: int, y: int) -> int:
        """x^y."""
        if self._is(y, 1):
            return x
        return self.number(1) if self._is(y, 0) else self.add("^", x, y)
