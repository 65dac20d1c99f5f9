"""A Lagrangian that is a function of Python, made a formula."""

import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy

from actio._errors import SceneError
from actio._formula_functions import FUNCTIONS
from actio._formula_text import formula_text, names_of
from actio._refusals import branches_refused, subject
from actio._trace import Trace
from actio._traced import Traced
from actio._traced_arrays import Names, traced_array, vector
from actio._values import kind, shown

_ARGUMENTS = "the velocity, the parameters and the carried vectors"


class Surroundings(NamedTuple):
    """What a Lagrangian may speak of."""

    components: Sequence[str]  #: of the velocity
    basis: Any  #: of the Lie algebra, as matrices: dimension by n by n
    parameters: Sequence[str]
    advected: Mapping[str, int]  #: the carried vectors, each with its length
    definitions: Sequence[str] = ()  #: names that formulas which are texts have besides


def _positional(lagrangian: Callable[..., Any]) -> int:
    """How many of the three arguments it is given: those that it has to have."""
    try:
        parameters = inspect.signature(lagrangian).parameters.values()
    except (TypeError, ValueError):
        raise TypeError(
            f"lagrangian: the arguments of {shown(lagrangian)} cannot be told; a function of one to three is"
            f" expected, of {_ARGUMENTS}"
        ) from None
    if any(each.kind is each.VAR_POSITIONAL for each in parameters):
        return 3
    needed = [each for each in parameters if each.default is each.empty and each.kind is not each.VAR_KEYWORD]
    named = [each.name for each in needed if each.kind is each.KEYWORD_ONLY]
    if named or not 1 <= len(needed) <= 3:
        found = f"one that needs {', '.join(named)} by name" if named else f"one of {len(needed)}"
        raise TypeError(
            f"lagrangian: a function of one, two or three arguments is expected, {_ARGUMENTS}, found {found}"
        )
    return len(needed)


def called(function: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
    """What it returns. What it raises is its own, but for a word on what NumPy says of traced numbers."""
    try:
        with branches_refused():
            return function(*arguments, **named)
    except TypeError as error:
        lacking = re.search(r"no callable (\w+) method", str(error))
        own = [name for name, (numpys, _) in FUNCTIONS.items() if lacking and numpys == lacking[1]]
        if lacking:
            raise SceneError(
                f"{subject().key}: numpy.{lacking[1]} "
                + (
                    f"does not take an array that mixes traced numbers and others; actio.{own[0]} does"
                    if own
                    else f"is no function of a formula, which has {', '.join(FUNCTIONS)}"
                )
            ) from error
        if "UFunc" not in type(error).__name__ and "einsum" not in str(error):
            raise
        raise SceneError(
            f"{subject().key}: NumPy says {shown(str(error))} of traced numbers; sums, products, @, dot,"
            " cross, tensordot and the functions of a formula take them"
        ) from error


def _hint(found: Any) -> str:
    if found is None:
        return "is a return missing?"
    if isinstance(found, (numpy.ndarray, list, tuple)):
        return "a sum over its items may be meant, or one of them"
    if isinstance(found, str):
        return "a Lagrangian that is a text is given in place of the function"
    return "it has to be made of what the function is given"


def _its_value(found: Any, trace: Trace, surroundings: Surroundings) -> Traced:
    """The number that came back, if it is one that can be a Lagrangian."""
    if isinstance(found, numpy.ndarray) and found.shape == ():
        found = found.item()
    if isinstance(found, Traced):
        if found._trace is not trace:
            raise SceneError(
                "lagrangian: it returned a number of another call; a Lagrangian is made of what it is given"
                " by this very call"
            )
        if names_of(trace, found._index).isdisjoint(surroundings.components):
            raise SceneError(
                f"lagrangian: it returned {formula_text(trace, found._index)}, which does not depend on the"
                f" velocity ({', '.join(surroundings.components)})"
            )
        return found
    if inspect.iscoroutine(found):
        found.close()
    is_number = isinstance(found, (int, float, complex, numpy.number))
    what = f"the constant {shown(found)}" if is_number else f"{shown(found)}, of type {kind(found)}"
    if isinstance(found, numpy.ndarray):
        what = f"an array of shape {found.shape}"
    raise SceneError(f"lagrangian: a number is expected of it, and it returned {what}; {_hint(found)}")


def symbols(trace: Trace, names: Sequence[str]) -> list[Traced]:
    """Numbers with names, without values."""
    return [Traced(trace, trace.add("symbol", name)) for name in names]


def carried_names(surroundings: Surroundings) -> dict[str, list[str]]:
    """The names of the components of each carried vector."""
    return {name: [f"{name}{k + 1}" for k in range(size)] for name, size in surroundings.advected.items()}


def formula_of(lagrangian: Callable[..., Any], surroundings: Surroundings) -> str:
    """The formula of a Lagrangian, from one call with symbols.

    lagrangian: a function of the velocity; of two arguments, of velocity and parameters; of three, of
        velocity, parameters and carried vectors.

    Raises SceneError where it branches, needs a float, is not smooth, or returns no number that depends on
    the velocity.
    """
    count = _positional(lagrangian)
    trace = Trace()
    carried = carried_names(surroundings)
    given = [
        vector(symbols(trace, surroundings.components), surroundings.components, surroundings.basis),
        Names("parameter", dict(zip(surroundings.parameters, symbols(trace, surroundings.parameters)))),
        Names("carried vector", {name: traced_array(symbols(trace, each)) for name, each in carried.items()}),
    ]
    value = _its_value(called(lagrangian, *given[:count]), trace, surroundings)
    items = [item for each in carried.values() for item in each]
    taken = [*surroundings.components, *surroundings.parameters, *items, *surroundings.definitions]
    return formula_text(trace, value._index, taken)
