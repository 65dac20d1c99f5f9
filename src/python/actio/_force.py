"""A force that is a function of Python, made formulas; and what it is given as functions of time."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

import numpy

from actio._errors import SceneError
from actio._formula_text import formula_text
from actio._lagrangian import Surroundings, called, carried_names, symbols
from actio._refusals import FORCE, tracing
from actio._trace import Trace, constant
from actio._traced import Traced
from actio._traced_arrays import Names, traced_array, vector
from actio._values import kind, shown

_ARGUMENTS = ("velocity", "momentum", "advected", "time", "parameters", "inputs")


def _wanted(force: Callable[..., Any]) -> list[str]:
    """The arguments of a force, by their names."""
    try:
        parameters = inspect.signature(force).parameters.values()
    except (TypeError, ValueError):
        raise TypeError(
            f"force: the arguments of {shown(force)} cannot be told; some of {', '.join(_ARGUMENTS)} are"
            " expected, by these names"
        ) from None
    names = [each.name for each in parameters if each.default is each.empty]
    wrong = [name for name in names if name not in _ARGUMENTS]
    if wrong or not names:
        found = f"'{wrong[0]}'" if wrong else "none"
        raise TypeError(
            f"force: its arguments are some of {', '.join(_ARGUMENTS)}, by these names, found {found}"
        )
    return names


def _component(found: Any, trace: Trace, name: str, taken: Sequence[str]) -> Union[str, float]:
    if isinstance(found, numpy.ndarray) and found.shape == ():
        found = found.item()
    if isinstance(found, Traced):
        if found._trace is not trace:
            raise SceneError(f"force: its component {name} is a number of another call")
        return formula_text(trace, found._index, taken)
    number = constant(found)
    if number is None:
        raise SceneError(
            f"force: a number is expected as its component {name}, found {shown(found)}, of type {kind(found)}"
        )
    return float(found)


def formulas_of(
    force: Callable[..., Any], surroundings: Surroundings, inputs: Sequence[str]
) -> dict[str, Union[str, float]]:
    """The formulas of a force by components, from one call with symbols.

    force: a function of some of `velocity`, `momentum`, `advected`, `time`, `parameters` and `inputs`, by
        these names; it returns a number for each component of the velocity, or a mapping of some of them.

    Raises SceneError where it branches, needs a float, or does not return so many numbers.
    """
    trace, components = Trace(), surroundings.components
    momenta = [f"p_{name}" for name in components]
    carried = carried_names(surroundings)
    wanted = _wanted(force)

    def made(name: str) -> Any:
        if name in ("velocity", "momentum"):
            of = components if name == "velocity" else momenta
            return vector(symbols(trace, of), components, surroundings.basis)
        if name == "advected":
            there = {each: traced_array(symbols(trace, items)) for each, items in carried.items()}
            return Names("carried vector", there)
        if name == "time":
            return symbols(trace, ["t"])[0]
        of = surroundings.parameters if name == "parameters" else inputs
        return Names(name[:-1], dict(zip(of, symbols(trace, of))))

    with tracing(FORCE):
        found = called(force, **{name: made(name) for name in wanted})
        if isinstance(found, Mapping):
            unknown = [name for name in found if name not in components]
            if unknown:
                raise SceneError(
                    f"force: it returned a component {shown(unknown[0])}; there is {', '.join(components)}"
                )
            values = dict(found)
        elif isinstance(found, (list, tuple, numpy.ndarray)) and len(found) == len(components):
            values = dict(zip(components, found))
        else:
            size = f" of {len(found)}" if isinstance(found, (list, tuple, numpy.ndarray)) else ""
            raise SceneError(
                f"force: {len(components)} numbers are expected of it, for {', '.join(components)}, or a"
                f" mapping of some of them; it returned {kind(found)}{size}"
            )
        items = [item for each in carried.values() for item in each]
        taken = [*components, *momenta, *surroundings.parameters, *items, *inputs, "t"]
        return {name: _component(value, trace, name, taken) for name, value in values.items()}


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
