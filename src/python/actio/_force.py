"""Forces and constraints that are functions of Python, made formulas; and inputs as functions of time."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

import numpy

from actio._errors import SceneError
from actio._formula_text import formula_text
from actio._lagrangian import Surroundings, called, carried_names, symbols
from actio._refusals import CONSTRAINTS, Subject, subject, tracing
from actio._trace import Trace, constant
from actio._traced import Traced
from actio._traced_arrays import Names, traced_array, vector
from actio._values import kind, shown

_ARGUMENTS = ("velocity", "momentum", "advected", "time", "parameters", "inputs")
_OF_CONSTRAINTS = ("velocity", "advected", "time", "parameters")


class _Call:
    """What a function returned to one call with symbols, under their names."""

    def __init__(
        self,
        function: Callable[..., Any],
        allowed: Sequence[str],
        surroundings: Surroundings,
        inputs: Sequence[str] = (),
    ) -> None:
        self.trace = Trace()
        self._carried = carried_names(surroundings)
        momenta = [f"p_{name}" for name in surroundings.components]
        items = [item for each in self._carried.values() for item in each]
        self._taken = [*surroundings.components, *momenta, *surroundings.parameters, *items, *inputs, "t"]
        self._taken += surroundings.definitions
        self._names = {"velocity": surroundings.components, "momentum": momenta}
        self._names.update(parameters=surroundings.parameters, inputs=inputs)
        given = {name: self._given(name, surroundings) for name in _wanted(function, allowed)}
        self.found = called(function, **given)

    def _given(self, name: str, surroundings: Surroundings) -> Any:
        if name == "advected":
            there = {each: traced_array(symbols(self.trace, items)) for each, items in self._carried.items()}
            return Names("carried vector", there)
        if name == "time":
            return symbols(self.trace, ["t"])[0]
        held = symbols(self.trace, self._names[name])
        if name in ("velocity", "momentum"):
            return vector(held, surroundings.components, surroundings.basis)
        return Names(name[:-1], dict(zip(self._names[name], held)))

    def formula(self, found: Any, name: str) -> Union[str, float]:
        """A number that was returned, as a formula."""
        if isinstance(found, numpy.ndarray) and found.shape == ():
            found = found.item()
        if isinstance(found, Traced):
            if found._trace is not self.trace:
                raise SceneError(f"{subject().key}: its {name} is a number of another call")
            return formula_text(self.trace, found._index, self._taken)
        if constant(found) is None:
            raise SceneError(
                f"{subject().key}: a number is expected as its {name}, found {shown(found)}, of type"
                f" {kind(found)}"
            )
        return float(found)


def _wanted(function: Callable[..., Any], allowed: Sequence[str]) -> list[str]:
    """The arguments of a function, by their names."""
    key = subject().key
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        raise TypeError(
            f"{key}: the arguments of {shown(function)} cannot be told; some of {', '.join(allowed)} are"
            " expected, by these names"
        ) from None
    names = [each.name for each in parameters if each.default is each.empty]
    wrong = [name for name in names if name not in allowed]
    if wrong or not names:
        found = f"'{wrong[0]}'" if wrong else "none"
        raise TypeError(
            f"{key}: its arguments are some of {', '.join(allowed)}, by these names, found {found}"
        )
    return names


def _is_list(found: Any) -> bool:
    return isinstance(found, (list, tuple)) or (isinstance(found, numpy.ndarray) and found.ndim == 1)


def formulas_of(
    force: Callable[..., Any], surroundings: Surroundings, inputs: Sequence[str], what: Subject
) -> dict[str, Union[str, float]]:
    """The formulas of a force by components, from one call with symbols.

    force: a function of some of `velocity`, `momentum`, `advected`, `time`, `parameters` and `inputs`, by
        these names; it returns a number for each component of the velocity, or a mapping of some of them.
    what: that it is called by.

    Raises SceneError where it branches, needs a float, or does not return so many numbers.
    """
    components = surroundings.components
    with tracing(what):
        call = _Call(force, _ARGUMENTS, surroundings, inputs)
        found = call.found
        if isinstance(found, Mapping):
            unknown = [name for name in found if name not in components]
            if unknown:
                raise SceneError(
                    f"{what.key}: it returned a component {shown(unknown[0])}; there is {', '.join(components)}"
                )
            values = dict(found)
        elif _is_list(found) and len(found) == len(components):
            values = dict(zip(components, found))
        else:
            size = f" of {len(found)}" if _is_list(found) else ""
            raise SceneError(
                f"{what.key}: {len(components)} numbers are expected of it, for {', '.join(components)}, or a"
                f" mapping of some of them; it returned {kind(found)}{size}"
            )
        return {name: call.formula(value, f"component {name}") for name, value in values.items()}


def constraints_of(constraints: Callable[..., Any], surroundings: Surroundings) -> list[Union[str, float]]:
    """The formulas of constraints on the velocity, from one call with symbols.

    constraints: a function of some of `velocity`, `advected`, `time` and `parameters`, by these names; it
        returns a list of numbers, which vanish along the motion.

    Raises SceneError where it branches, needs a float, is not smooth, or returns no list.
    """
    with tracing(CONSTRAINTS):
        call = _Call(constraints, _OF_CONSTRAINTS, surroundings)
        if not _is_list(call.found):
            raise SceneError(
                f"constraints: a list of numbers is expected of it; it returned {kind(call.found)}"
            )
        return [call.formula(value, f"number {k + 1}") for k, value in enumerate(call.found)]


def checked_inputs(inputs: Mapping[str, Any]) -> dict[str, Any]:
    """Each a formula of t, or rows of a time and the value from then on."""
    out: dict[str, Any] = {}
    for name, value in inputs.items():
        if isinstance(value, (str, int, float)) and not isinstance(value, bool):
            out[name] = value
            continue
        try:
            rows = numpy.asarray(value, dtype=float)
        except (TypeError, ValueError):
            rows = numpy.empty(0)
        if rows.ndim != 2 or rows.shape[1] != 2:
            raise SceneError(
                f"inputs: {name}: a formula of t or rows of a time and a value are expected, found"
                f" {shown(value)}"
            )
        out[name] = rows.tolist()
    return out
