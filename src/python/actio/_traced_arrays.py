"""What a Lagrangian is given: arrays of traced numbers, whose items may have names."""

import difflib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy

from actio._formula_functions import FUNCTIONS
from actio._traced import Traced, TracedArray, apply
from actio._values import shown


def on_items(name: str, arguments: Sequence[Any]) -> Any:
    """A function of a formula at numbers or arrays, item by item."""
    function = getattr(numpy, FUNCTIONS[name][0])
    held = [numpy.array(each) if isinstance(each, (list, tuple)) else each for each in arguments]
    if any(isinstance(each, Traced) or getattr(each, "dtype", None) == object for each in held):
        return apply(function, "__call__", held, {})
    return function(*held)


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

