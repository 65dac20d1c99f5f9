"""Paths, as the system has them."""

import os
from typing import Any, Union

from actio._errors import SceneError
from actio._values import kind, shown

Path = Union[str, "os.PathLike[str]"]


def encoded_path(path: Any, what: str) -> bytes:
    """A path as the system has it."""
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(
            f"{what}: a path is a text or a path object, found {shown(path)}, of type {kind(path)}"
        )
    try:
        found = os.fspath(path)
    except Exception as error:
        raise TypeError(
            f"{what}: __fspath__() of this object of type {kind(path)} failed: {shown(error)}"
        ) from error
    if not isinstance(found, str):
        raise TypeError(f"{what}: a path is a text, found {shown(found)}, of type {kind(found)}")
    if len(found) > 4096:
        raise SceneError(
            f"{what}: a path has at most 4096 characters, found one of {len(found)}: {shown(found)}"
        )
    if "\0" in found:
        raise SceneError(f"{what}: a path holds no NUL, found {shown(found)}")
    try:
        return os.fsencode(found)
    except UnicodeEncodeError:
        raise SceneError(f"{what}: the path {shown(found)} is no text that names of files can have") from None
