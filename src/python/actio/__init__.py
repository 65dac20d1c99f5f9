"""Mechanics on Lie groups, step by step, from one action principle.

    import actio

    run = actio.run("apophis.toml", set={"method.order": 4})
    run["body_momentum"]                    # a NumPy array, one row for each time
    actio.load("apophis")                   # the run that the command has left in a folder
    actio.sweep("apophis.toml", over={"method.step": [0.1, 0.2]})

`run`, `load` and `sweep` make runs; `systems`, `quantities`, `bodies` and `groups` tell what there is.
"""

try:
    import numpy as _numpy  # noqa: F401
except ImportError as _error:
    raise ImportError(
        "actio needs NumPy, which this interpreter does not have (Debian: python3-numpy, for"
        " /usr/bin/python3)"
    ) from _error

from actio._errors import Error, FileError, NumericsError, SceneError, Stopped
from actio._registry import bodies, groups, quantities, systems
from actio._run import Run
from actio._running import load, run
from actio._sweep import Member, Sweep, sweep
from actio._actio import version as __version__

__all__ = [
    "Error",
    "FileError",
    "Member",
    "NumericsError",
    "Run",
    "SceneError",
    "Stopped",
    "Sweep",
    "bodies",
    "groups",
    "load",
    "quantities",
    "run",
    "sweep",
    "systems",
    "__version__",
]
