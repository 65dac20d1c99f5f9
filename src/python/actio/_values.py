"""Values of Python as a scene writes them, in TOML.

A scene holds numbers, texts, truths and lists of them, in tables. Of NumPy scalars and arrays are taken,
and whatever else has a method `tolist`; numbers of any kind that is real. Nothing here trusts what it is
given: lists may hold themselves.
"""

import numbers
import os
import re
import reprlib
from collections.abc import Iterator, Mapping
from typing import Any, Optional

from actio._errors import SceneError

# A scene has at most four megabytes.
MOST_ITEMS = 250_000
MOST_CHARACTERS = 4 << 20
DEEPEST = 32
LONGEST_NAME = 200
_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")
_KEY = re.compile(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*(\[[0-9]+\])*\Z")
_BRIEF = reprlib.Repr()
_BRIEF.maxlevel, _BRIEF.maxstring, _BRIEF.maxother = 2, 57, 57
_TO_ESCAPE = re.compile(r'["\\\x00-\x1f\x7f]')
_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r"}


def shown(value: Any) -> str:
    """The value for a message, shortened, whatever its `repr` does."""
    try:
        text = _BRIEF.repr(value)
    except Exception:
        text = f"an object of {type(value).__name__}"
    text = text.encode("utf-8", "backslashreplace").decode("utf-8")
    return text if len(text) <= 60 else text[:57] + "..."


def kind(value: Any) -> str:
    """What a value is, for a message: `set`, `numpy.datetime64`."""
    its = type(value)
    return its.__name__ if its.__module__ == "builtins" else f"{its.__module__}.{its.__name__}"


def in_utf8(text: str, where: str) -> bytes:
    """The bytes of a text."""
    try:
        return str.encode(text, "utf-8")
    except UnicodeEncodeError as error:
        raise SceneError(
            f"{where}: a text in Unicode is expected, found a lone surrogate at character {error.start + 1}"
        ) from None


def quoted(text: str, where: str) -> str:
    """A text between quotes."""
    if str.__len__(text) > MOST_CHARACTERS:
        raise SceneError(
            f"{where}: a text has at most {MOST_CHARACTERS} characters, found one of {str.__len__(text)}"
        )
    in_utf8(text, where)
    return '"' + _TO_ESCAPE.sub(lambda found: _ESCAPES.get(found[0]) or f"\\u{ord(found[0]):04x}", text) + '"'


class _Writer:
    """Writes one value; `where` names it in messages."""

    def __init__(self, where: str) -> None:
        self.where = where
        self.items = 0
        self.open: list[int] = []  # the lists that lead to what is being written

    def write(self, value: Any) -> str:
        self.items += 1
        if self.items > MOST_ITEMS:
            raise SceneError(f"{self.where}: a value has at most {MOST_ITEMS} items")
        simple = self.simple(value)
        if simple is not None:
            return simple
        if isinstance(value, (list, tuple, Mapping)):
            return self.nested(value)
        return self.converted(value)

    def simple(self, value: Any) -> Optional[str]:
        """Of a truth, a number, a text or a path; None of all else."""
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, int):
            return self.integer(value)
        if isinstance(value, float):
            return float.__repr__(value)
        if isinstance(value, str):
            return quoted(value, self.where)
        if isinstance(value, os.PathLike):
            path = self.asked(value, "__fspath__", os.fspath)
            return quoted(path if isinstance(path, str) else os.fsdecode(path), self.where)
        return None

    def integer(self, value: int) -> str:
        if not -(2**63) <= value < 2**63:
            raise SceneError(
                f"{self.where}: a whole number of a scene has 64 bits, and this one has {value.bit_length()};"
                " write it as a float"
            )
        return int.__repr__(value)

    def nested(self, value: Any) -> str:
        if id(value) in self.open:
            raise SceneError(f"{self.where}: a list that holds itself is no value of a scene")
        if len(self.open) >= DEEPEST:
            raise SceneError(f"{self.where}: lists are nested at most {DEEPEST} deep")
        self.open.append(id(value))
        if isinstance(value, Mapping):
            entries = [(key, item) for key, item in _entries(value, self.where) if item is not None]
            written = [f"{_key(key, self.where)} = {self.write(item)}" for key, item in entries]
            text = "{" + ", ".join(written) + "}"
        else:
            text = "[" + ", ".join([self.write(item) for item in value]) + "]"
        self.open.pop()
        return text

    def converted(self, value: Any) -> str:
        """Of what can be made a list or a number: arrays and scalars of NumPy, fractions."""
        if callable(getattr(type(value), "tolist", None)):
            found = self.asked(value, "tolist", lambda array: array.tolist())
            if isinstance(found, (bool, int, float, str, list, tuple)):
                return self.write(found)
        if isinstance(value, numbers.Real):
            return float.__repr__(self.asked(value, "__float__", float))
        raise TypeError(
            f"{self.where}: a scene holds numbers, texts, truths and lists of them, and this is of type"
            f" {kind(value)}"
        )

    def asked(self, value: Any, name: str, ask: Any) -> Any:
        """What an object answers. What it raises is told as what it is: no value."""
        try:
            return ask(value)
        except Exception as error:
            raise TypeError(
                f"{self.where}: {name}() of this object of type {kind(value)} failed: {shown(error)}"
            ) from error


def in_toml(value: Any, where: str) -> str:
    """`0.1`, `true`, `"a text"`, `[1, 2]`. Raises TypeError where it is of a wrong type, SceneError where a
    scene cannot say it."""
    return _Writer(where).write(value)


def name_in_toml(name: Any, where: str) -> str:
    """A single name, between quotes where it needs them."""
    if not isinstance(name, str):
        raise TypeError(f"{where}: a name of a scene is a text, found {shown(name)}, of type {kind(name)}")
    return str(name) if _BARE.match(name) else quoted(name, where)


def _entries(table: Mapping[str, Any], what: str) -> list[tuple[str, Any]]:
    try:
        entries = list(table.items())
    except Exception as error:
        raise TypeError(f"{what}: items() of this {kind(table)} failed: {shown(error)}") from error
    for entry in entries:
        if not isinstance(entry, tuple) or len(entry) != 2:
            raise TypeError(
                f"{what}: a mapping of names and values is expected, its items() has {shown(entry)}"
            )
        if not isinstance(entry[0], str):
            raise TypeError(
                f'{what}: the keys are texts such as "method.step", found {shown(entry[0])}, of type'
                f" {kind(entry[0])}"
            )
    return entries


def _key(name: str, what: str) -> str:
    """Names joined by dots, each between quotes where it needs them."""
    if len(name) > LONGEST_NAME:
        raise SceneError(
            f"{what}: a key has at most {LONGEST_NAME} characters, found one of {len(name)}: {shown(name)}"
        )
    return name if _KEY.match(name) else ".".join(name_in_toml(part, what) for part in str(name).split("."))


def leaves(
    table: Mapping[str, Any], what: str, before: str = "", depth: int = 0
) -> Iterator[tuple[str, Any]]:
    """Keys with dots between their names, and the values that are no tables, or empty ones."""
    if depth > DEEPEST:
        raise SceneError(f"{what}: tables are nested at most {DEEPEST} deep")
    for name, value in _entries(table, what):
        key = _key(name, what)
        if isinstance(value, Mapping) and _entries(value, what):
            yield from leaves(value, what, before + key + ".", depth + 1)
        else:
            yield before + key, value


def changes(table: Optional[Mapping[str, Any]], what: str = "set") -> list[tuple[bytes, bool]]:
    """What is set, KEY=VALUE, and what is taken out, KEY with True. A mapping takes the place of the table
    that was there, as it does on the command line."""
    if table is None:
        return []
    if not isinstance(table, Mapping):
        raise TypeError(
            f'{what}: a mapping of keys and values is expected, such as {{"method.step": 0.1}}, found'
            f" {shown(table)}, of type {kind(table)}"
        )
    out = []
    for name, value in _entries(table, what):
        key = _key(name, what)
        text = key if value is None else f"{key}={in_toml(value, f'{what}: {key}')}"
        out.append((in_utf8(text, what), value is None))
    return out


class SceneText:
    """A scene that was given as a mapping, as a text in TOML, and which key each of its lines holds."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        self.lines: list[str] = []
        self.keys: dict[int, str] = {}
        self._section(_tree(scene), "")

    @property
    def text(self) -> bytes:
        return in_utf8("\n".join(self.lines) + "\n", "scene")

    def _section(self, tree: dict[str, Any], path: str) -> None:
        if path:
            self.lines.append(f"[{path}]")
            self.keys[len(self.lines)] = path
        for name, value in tree.items():
            if not isinstance(value, dict):
                key = f"{path}.{name}" if path else name
                self.lines.append(f"{name} = {in_toml(value, key)}")
                self.keys[len(self.lines)] = key
        for name, value in tree.items():
            if isinstance(value, dict):
                self._section(value, f"{path}.{name}" if path else name)


def _tree(scene: Mapping[str, Any]) -> dict[str, Any]:
    """The same with a dictionary for each table, names as TOML writes them, and without what is None."""
    root: dict[str, Any] = {}
    for key, value in leaves(scene, "scene"):
        *path, last = re.findall(r'"(?:[^"\\]|\\.)*"|[^.]+', key)
        at = root
        for name in path:
            at = at.setdefault(name, {})
            if not isinstance(at, dict):
                raise SceneError(f"{key}: '{name}' is a value and a table at once")
        if last in at:
            raise SceneError(f"{key}: is there twice")
        if value is not None:
            at[last] = {} if isinstance(value, Mapping) else value
    return root
