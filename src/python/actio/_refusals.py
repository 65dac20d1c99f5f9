"""What a traced function cannot do with its arguments: errors that name the line of the user's code."""

import contextlib
import contextvars
import linecache
import os
import re
import sys
from collections.abc import Iterator
from typing import NamedTuple, NoReturn

import numpy

from actio._errors import SceneError
from actio._formula_functions import FUNCTIONS, KINKED
from actio._values import shown

_NOT_THE_USERS = (
    os.path.join(os.path.dirname(__file__), ""),
    os.path.join(os.path.dirname(numpy.__file__), ""),
    "<__array_function__",
)


class Subject(NamedTuple):
    """What is traced."""

    key: str  #: of a scene, which complaints begin with
    words: str  #: "a Lagrangian"
    smooth: bool  #: whether it is differentiated


LAGRANGIAN = Subject("lagrangian", "a Lagrangian", True)
FORCE = Subject("force", "a force", False)
FORCE_IN_SPACE = Subject("force_in_space", "a force", False)
CONSTRAINTS = Subject("constraints", "a constraint", True)
_subject: contextvars.ContextVar[Subject] = contextvars.ContextVar("subject", default=LAGRANGIAN)


def subject() -> Subject:
    """What is traced now."""
    return _subject.get()


@contextlib.contextmanager
def tracing(what: Subject) -> Iterator[None]:
    """While it is traced, refusals speak of it."""
    before = _subject.set(what)
    try:
        yield
    finally:
        _subject.reset(before)


def _place() -> tuple[str, str]:
    """File and line of the user's code that is running, and the text of that line."""
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_NOT_THE_USERS):
        frame = frame.f_back
    name, line = frame.f_code.co_filename, frame.f_lineno
    return f"{name}:{line}", linecache.getline(name, line, frame.f_globals).strip()


def _refusal(why: str) -> SceneError:
    where, text = _place()
    return SceneError(f"{subject().key}: {where}: " + (f"`{shown(text)[1:-1]}`: " if text else "") + why)


def refuse(why: str) -> NoReturn:
    """Raises SceneError, which names the line of the user's code."""
    raise _refusal(why)


# What was refused of the branches of the call that is going on.
_branches: contextvars.ContextVar[list[SceneError]] = contextvars.ContextVar("branches")


def refuse_branch(what: str) -> NoReturn:
    """Of what asks for a value: a comparison, a truth."""
    error = _refusal(
        f"{what}; {subject().words} is called once, with symbols in place of numbers, and has to be one"
        f"{' smooth' if subject().smooth else ''} formula whatever their values are"
    )
    _branches.get([]).append(error)
    raise error


@contextlib.contextmanager
def branches_refused() -> Iterator[None]:
    """A branch that is refused inside is an error at the end, whatever becomes of it meanwhile: NumPy before
    1.25 takes an error in x == y for the answer that they differ."""
    found: list[SceneError] = []
    before = _branches.set(found)
    try:
        yield
    finally:
        _branches.reset(before)
        if found:
            raise found[0] from None


def refuse_corner(what: str) -> NoReturn:
    """Of a function that is not smooth, and no function of a formula, or of one that has to be smooth."""
    if subject().smooth:
        refuse(f"{what} is not smooth, and {subject().words} has to be smooth")
    refuse(f"{what} is no function of a formula, which has {', '.join(FUNCTIONS)}, {', '.join(KINKED)}")


def refuse_whole() -> NoReturn:
    """Of what needs a whole number, such as range."""
    refuse("a whole number is needed here, and this number is traced: it has no value")


def refuse_float() -> NoReturn:
    """Of what needs a number here and now, such as math.sin."""
    found = re.search(r"\bmath\.(\w+)", _place()[1])
    if found and found[1] in FUNCTIONS:
        name, numpys = found[1], FUNCTIONS[found[1]][0]
        refuse(f"math.{name} needs a float, and this number is traced; use actio.{name} or numpy.{numpys}")
    refuse(
        "a float is needed here, and this number is traced: it has no value; in place of the functions of"
        " math use those of actio or of numpy, actio.sin or numpy.sin for instance"
    )
