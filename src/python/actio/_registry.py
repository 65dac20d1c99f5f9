"""What the library knows by name."""

from typing import Any

from actio import _actio
from actio._errors import SceneError
from actio._values import shown


def _by_name(entries: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    return {entry["name"]: entry for entry in entries}


def systems() -> dict[str, dict[str, Any]]:
    """The systems that a scene can simulate, by name: title, meaning, statement of the thesis, parameters,
    methods and quantities, each of these a list of dictionaries."""
    return _by_name(_actio.systems())


def quantities(kind: str) -> dict[str, dict[str, Any]]:
    """The quantities of a system, by name: kind, unit, meaning, formula (TeX), statement, what it needs,
    whether it is conserved."""
    known = systems()
    if not isinstance(kind, str) or kind not in known:
        raise SceneError(f"quantities: a system is expected ({', '.join(known)}), found {shown(kind)}")
    return _by_name(known[kind]["quantities"])


def bodies() -> dict[str, dict[str, Any]]:
    """The bodies of the catalogue, by name: title, moments of inertia and their unit, axes, spin and its
    unit of time, source, and what was derived from it."""
    return _by_name(_actio.bodies())


def groups() -> dict[str, dict[str, Any]]:
    """The groups of the library, by name: dimension, meaning, coordinates, type and header in C++,
    statement."""
    return _by_name(_actio.groups())
