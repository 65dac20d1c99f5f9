"""Runs of scenes, and runs that are read back from folders."""

import os
import re
import warnings
from collections.abc import Callable, Mapping
from typing import Any, Optional, Union

from actio import _actio
from actio._errors import Error, FileError, NumericsError, SceneError
from actio._paths import Path, encoded_path
from actio._run import Run
from actio._values import SceneText, changes, in_utf8, kind, shown

SceneLike = Union[Path, Mapping[str, Any]]
Progress = Callable[[float, float], Any]

_DONE, _INTERRUPTED, _FILE_FAILED = 0, 130, 4


class Source:
    """The scene of a run, from whichever argument it comes: what the compiled part needs of it."""

    def __init__(self, scene: Optional[SceneLike], text: Optional[str], who: str) -> None:
        self.keys: dict[int, str] = {}
        if (scene is None) == (text is None):
            raise TypeError(f"{who}: either a scene (a path or a mapping) or text=... is needed")
        self.is_text, self.name = True, b"text"
        if isinstance(scene, Mapping):
            written = SceneText(scene)
            self.source, self.name, self.keys = written.text, b"scene", written.keys
        elif text is None:
            self.source, self.is_text = self._path(scene), False
        elif isinstance(text, str):
            self.source = in_utf8(text, "text")
        else:
            raise TypeError(f"text: a scene in TOML is a text, found {shown(text)}, of type {kind(text)}")

    @staticmethod
    def _path(scene: Any) -> bytes:
        if not isinstance(scene, (str, os.PathLike)):
            raise TypeError(
                f"scene: a path or a mapping is expected, found {shown(scene)}, of type {kind(scene)}"
            )
        if isinstance(scene, str) and "\n" in scene:
            raise SceneError(
                "scene: the path of a scene is expected, found a text of several lines; a scene itself is"
                " given as text=..."
            )
        return encoded_path(scene, "scene")

    def in_words_of_the_caller(self, message: str) -> str:
        """Places in a text that was made here are told by the key that stands there, arguments of the
        command by those of Python."""
        place = re.match(r"scene:(\d+):\d+: ", message) if self.keys else None
        if place:
            return self.keys.get(int(place[1]), "scene") + ": " + message[place.end() :]
        return "set: " + message[6:] if message.startswith("--set ") else message


def outcome(
    source: Source, over: list[tuple[bytes, bool]], told: Optional[Progress]
) -> tuple[Run, Optional[BaseException]]:
    """Runs it: the rows that there are, and what ended the run before its end, if anything did."""
    try:
        table, about, ending, message, raised = _actio.run(
            source.source, source.is_text, source.name, over, told
        )
    except Error as error:
        raise type(error)(source.in_words_of_the_caller(str(error))) from None
    except MemoryError:
        raise Error(
            "the memory that is available does not suffice for the table of this run; `actio run` writes as"
            " it goes"
        ) from None
    run = Run._of(table, about)
    if raised is None and ending not in (_DONE, _INTERRUPTED):
        raised = (FileError if ending == _FILE_FAILED else NumericsError)(
            source.in_words_of_the_caller(message)
        )
    return run, raised


def warn_of_files(over: list[tuple[bytes, bool]]) -> None:
    """Says which of the changes are for files, which a run in memory does not write."""
    for text, _ in over:
        for name in ("plots", "formats"):
            if re.match(rf"output(\.{name}=|=\{{.*\b{name} = )", text.decode()):
                warnings.warn(
                    f"output.{name} has no effect on a run in memory, which writes no file before Run.save",
                    stacklevel=3,
                )


def checked_call(told: Any, what: str) -> Any:
    """A function, or None."""
    if told is not None and not callable(told):
        raise TypeError(f"{what}: a function is expected, found {shown(told)}, of type {kind(told)}")
    return told


def checked_choice(choice: Any, allowed: tuple[str, ...], what: str) -> Any:
    """One of some words."""
    if not isinstance(choice, str) or choice not in allowed:
        raise ValueError(
            f"{what}: {' or '.join(repr(word) for word in allowed)} is expected, found {shown(choice)}"
        )
    return choice


def attach(error: BaseException, name: str, value: Any) -> None:
    """What was computed before an exception, as an attribute of it, where it takes one."""
    try:
        setattr(error, name, value)
    except Exception:
        pass


def run(
    scene: Optional[SceneLike] = None,
    *,
    text: Optional[str] = None,
    set: Optional[Mapping[str, Any]] = None,
    progress: Optional[Progress] = None,
    on_interrupt: str = "raise",
) -> Run:
    """Runs a scene and returns its `Run`.

    scene: the path of a scene in TOML; or the scene itself as a mapping, {"system": {"kind": "rigid_body",
        ...}, ...}.
    text: the scene itself, in TOML.
    set: keys to set over it, {"method.order": 4, "system.body": "apophis"}. None takes a key out; a mapping
        takes the place of the table that was there.
    progress: called with the fraction that is done, from 0 to 1, and the time in the scene, four times a
        second and at the end. Where what it returns is true, the run ends there, and the rows so far are
        returned.
    on_interrupt: "raise", Ctrl-C raises KeyboardInterrupt; "return", the rows so far are returned.

    Where [output] of the scene asks for snapshots, they are `Run.snapshots`.

    No file is written. The table is held in memory, at 8 bytes a number, rows times columns. What is larger
    is run by the command `actio run`, which writes as it goes. Other threads go on meanwhile.

    Raises SceneError, NumericsError or FileError, all of them Error, with the message that the command
    would give. An exception that ended a run that had begun, KeyboardInterrupt included, has the rows so
    far as its attribute `run`.
    """
    checked_call(progress, "progress")
    checked_choice(on_interrupt, ("raise", "return"), "on_interrupt")
    source, over = Source(scene, text, "run"), changes(set)
    warn_of_files(over)
    found, raised = outcome(source, over, progress)
    if raised is not None and not (isinstance(raised, KeyboardInterrupt) and on_interrupt == "return"):
        attach(raised, "run", found)
        raise raised
    if progress is not None and raised is None and found.summary["status"] == "done":
        progress(1.0, float(found.t[-1]))
    return found


def load(folder: Path) -> Run:
    """The run that the command has left in a folder, or that `Run.save` has: every row that is there, bit
    for bit, and as `Run.snapshots` the snapshots.

    A run that was interrupted, or that goes on while it is read, has the rows that are whole. Where it has
    not said yet how it ended, `summary` is {"status": "unfinished"} with the number of rows.
    """
    where = encoded_path(folder, "folder")
    try:
        table, about, *_ = _actio.load(where)
        about["folder"] = os.path.abspath(where)
    except MemoryError:
        raise Error("the memory that is available does not suffice for the table of this run") from None
    return Run._of(table, about)
