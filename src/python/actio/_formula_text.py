"""What was traced, as a formula of a scene: `t1 = x1*x2; t1 + t1^2/2`."""

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

from actio._trace import Entry, Trace

# How tightly the last operation of a text binds; one whose arguments bind less puts these in brackets.
_SUM, _PRODUCT, _POWER, _ATOM = 1, 2, 3, 4
# (left, right, what comes out): a + (b + c) keeps its brackets, since sums of doubles are not associative.
_BINDS = {
    "+": (_SUM, _PRODUCT, _SUM),
    "-": (_SUM, _PRODUCT, _SUM),
    "*": (_PRODUCT, _POWER, _PRODUCT),
    "/": (_PRODUCT, _POWER, _PRODUCT),
    "^": (_ATOM, _ATOM, _POWER),
}
# A part that is longer, or has more brackets in brackets, is defined before it is used, so that no text grows
# with the square of the number of operations.
_LONGEST, _DEEPEST = 400, 20


class _Text(NamedTuple):
    text: str
    binds: int
    depth: int

    def within(self, binds: int) -> str:
        return self.text if self.binds >= binds else f"({self.text})"


def _constant(value: Any) -> _Text:
    if value == math.pi:
        return _Text("pi", _ATOM, 0)
    if isinstance(value, tuple):
        return _Text(f"{value[0]}/{value[1]}", _PRODUCT if value[0] >= 0 else _SUM, 0)
    text = repr(value).replace("e+", "e")
    return _Text(text, _ATOM if value >= 0 else _SUM, 0)


def reached(trace: Trace, index: int) -> list[int]:
    """The entries of the table that an entry depends on, itself included, arguments first."""
    ahead, found = [index], {index}
    while ahead:
        for argument in arguments(trace.entries[ahead.pop()]):
            if argument not in found:
                found.add(argument)
                ahead.append(argument)
    return sorted(found)


def arguments(entry: Entry) -> tuple[int, ...]:
    """The entries that an entry is made of."""
    return () if entry[0] in ("symbol", "constant") else entry[1:]


def names_of(trace: Trace, index: int) -> set[str]:
    """The names of the symbols that an entry depends on."""
    entries = [trace.entries[each] for each in reached(trace, index)]
    return {entry[1] for entry in entries if entry[0] == "symbol"}


def _prefix(names: Iterable[str]) -> str:
    """Letters with which the names of definitions begin, and no other name does."""
    prefix, taken = "t", tuple(names)
    while any(name.startswith(prefix) and name[len(prefix) :].isdigit() for name in taken):
        prefix += "_"
    return prefix


class _Writer:
    def __init__(self, trace: Trace, needed: list[int], prefix: str) -> None:
        self.trace, self.prefix = trace, prefix
        self.texts: dict[int, _Text] = {}
        self.definitions: list[str] = []
        self.uses = dict.fromkeys(needed, 0)
        for index in needed:
            for argument in arguments(trace.entries[index]):
                self.uses[argument] += 1

    def write(self, index: int) -> None:
        entry = self.trace.entries[index]
        text = self.entry(entry)
        if arguments(entry) and (self.uses[index] > 1 or len(text.text) > _LONGEST or text.depth > _DEEPEST):
            text = self.defined(text)
        self.texts[index] = text

    def defined(self, text: _Text) -> _Text:
        name = f"{self.prefix}{len(self.definitions) + 1}"
        self.definitions.append(f"{name} = {text.text}; ")
        return _Text(name, _ATOM, 0)

    def entry(self, entry: Entry) -> _Text:
        operation = entry[0]
        if operation == "symbol":
            return _Text(entry[1], _ATOM, 0)
        if operation == "constant":
            return _constant(entry[1])
        parts = [self.texts[argument] for argument in entry[1:]]
        depth = 1 + max(part.depth for part in parts)
        if operation not in _BINDS:
            return _Text(f"{operation}({', '.join(part.text for part in parts)})", _ATOM, depth)
        if len(parts) == 1:
            return _Text("-" + parts[0].within(_PRODUCT), _SUM, depth)
        left, right, binds = _BINDS[operation]
        sign = f" {operation} " if binds == _SUM else operation
        opened = parts[0].binds < left or parts[1].binds < right
        text = parts[0].within(left) + sign + parts[1].within(right)
        return _Text(text, binds, depth if opened else depth - 1)


def formula_text(trace: Trace, index: int, taken: Iterable[str] = ()) -> str:
    """The formula whose value the entry is. What enters it more than once is defined first, `t1 = ...; `.

    taken: names that a definition does not have, besides those of the formula itself.
    """
    needed = reached(trace, index)
    writer = _Writer(trace, needed, _prefix([*names_of(trace, index), *taken]))
    for each in needed:
        writer.write(each)
    return "".join(writer.definitions) + writer.texts[index].text
