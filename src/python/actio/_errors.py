"""What can go wrong: the exceptions of the package, which the compiled part throws."""

from actio._actio import Error, FileError, NumericsError, SceneError

__all__ = ["Error", "FileError", "NumericsError", "SceneError", "Stopped"]

Error.__doc__ = """Whatever goes wrong in actio.

Where rows had been computed by then, the attribute `run` is the `Run` that holds them."""
SceneError.__doc__ = "The scene is wrong; the message names the place, what was found and what is allowed."
NumericsError.__doc__ = "The numerics failed: a step too long for its method, no convergence."
FileError.__doc__ = "A file could not be read or written."


class Stopped(Error):
    """A member of a sweep that was not run to its end, since the sweep was stopped."""


for _class in (Error, SceneError, NumericsError, FileError, Stopped):
    _class.__module__ = "actio"
    _class.__qualname__ = _class.__name__
