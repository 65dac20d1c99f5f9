"""What `pip install .` and `pip wheel .` call: builds the package actio with CMake, and packs it.

A build backend in the sense of PEP 517 and 660, on the standard library alone, so that nothing has to be
fetched to build. What is needed is a compiler, CMake and the libraries that the command is built with, and
pybind11; the headers of Python are those of the interpreter that runs this.

    pip install .                                                   # builds in build-wheel
    pip install --config-settings build-folder=build .              # in a folder that CMake has made ready before
    ACTIO_WHEEL_BUILD=build pip install .                           # the same
"""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The parts of the project that the package does not need.
LEFT_OUT = ["CHAPTERS", "CHECKS", "TESTS", "BENCHMARKS"]


class CannotBuild(SystemExit):
    """What is missing, in a sentence."""

    def __init__(self, why):
        super().__init__(f"actio cannot be built: {why}")


# ---- What the package is called


def described():
    """Version and description, as CMake knows them."""
    text = (ROOT / "CMakeLists.txt").read_text()
    version = re.search(r"project\(actio VERSION ([0-9.]+)", text)
    description = re.search(r'DESCRIPTION "([^"]*)"', text)
    return version[1], description[1]


def metadata():
    """The file METADATA."""
    version, description = described()
    lines = [
        "Metadata-Version: 2.1",
        "Name: actio",
        f"Version: {version}",
        f"Summary: {description}",
        "Requires-Python: >=3.9",
        "Requires-Dist: numpy",
        "License-File: LICENSE",
    ]
    return "\n".join(lines) + "\n"


def tag():
    """For which interpreters a wheel is: this one, on this platform."""
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    platform = re.sub(r"[^A-Za-z0-9]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def information():
    """The folder of what a wheel tells of itself, file by file, without its list of files."""
    wheel = f"Wheel-Version: 1.0\nGenerator: actio_wheel\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {
        "METADATA": metadata().encode(),
        "WHEEL": wheel.encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
    }


def information_folder():
    return f"actio-{described()[0]}.dist-info"


# ---- Building


def check_interpreter():
    """That a module can be compiled for the interpreter that runs this."""
    if sys.implementation.name != "cpython" or sys.version_info < (3, 9):
        raise CannotBuild(
            f"CPython 3.9 or later is needed, and {sys.executable} is"
            f" {sys.implementation.name} {sys.version.split()[0]}"
        )
    headers = pathlib.Path(sysconfig.get_path("include"), "Python.h")
    if not headers.exists():
        raise CannotBuild(
            f"the headers of {sys.executable} are not there: {headers} (Debian: python3-dev, for"
            " /usr/bin/python3)"
        )
    if not shutil.which("cmake"):
        raise CannotBuild("CMake is not there (Debian: cmake)")


def setting(config, name, otherwise):
    value = (config or {}).get(name, otherwise)
    if not isinstance(value, str):
        raise CannotBuild(f"--config-settings {name}=... is expected once, found {value!r}")
    return value


def called(*command):
    """Runs a command; what it says, which is also shown where it fails."""
    done = subprocess.run(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    )
    if done.returncode != 0:
        print(done.stdout, file=sys.stderr)
        raise CannotBuild(
            f"`{' '.join(map(str, command))}` failed with status {done.returncode}; what it said is above"
        )
    return done.stdout


def configure(build):
    """Makes a new folder ready for this interpreter."""
    command = [
        "cmake",
        "-S",
        str(ROOT),
        "-B",
        str(build),
        "-DCMAKE_BUILD_TYPE=Release",
        f"-DPython_EXECUTABLE={sys.executable}",
    ]
    command += [f"-DACTIO_BUILD_{part}=OFF" for part in LEFT_OUT]
    if shutil.which("ninja"):
        command += ["-G", "Ninja"]
    missing = re.search(r"The package actio of Python is not built: (.*)", called(*command))
    if missing:
        shutil.rmtree(build)  # what is missing may be there the next time
        raise CannotBuild(missing[1])


def built(config):
    """The folder of the package, built for this interpreter."""
    check_interpreter()
    name = setting(config, "build-folder", os.environ.get("ACTIO_WHEEL_BUILD", ""))
    # One for each kind of interpreter: the module of one cannot be loaded by another.
    build = ROOT / (name or f"build-wheel/{sysconfig.get_config_var('SOABI')}")
    if not (build / "CMakeCache.txt").exists():
        configure(build)
    called("cmake", "--build", str(build), "--target", "actio_python", "--parallel", str(os.cpu_count() or 1))
    package = build / "python" / "actio"
    if not module(package).exists():
        there = ", ".join(path.name for path in package.glob("_actio.*.so")) or "none"
        raise CannotBuild(
            f"{build} makes the module for another interpreter than {sys.executable} ({there}); another"
            " build-folder will do"
        )
    return package


def module(package):
    """The compiled part, for this interpreter."""
    return package / f"_actio{sysconfig.get_config_var('EXT_SUFFIX')}"


def sources():
    """The parts of the package that are not compiled."""
    return sorted(
        path for path in (ROOT / "src/python/actio").iterdir() if path.suffix in (".py", ".pyi", ".typed")
    )


# ---- Packing


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def packed(directory, files):
    """A wheel of these files; its name. The same files make the same wheel, to the byte."""
    folder = information_folder()
    files = {**files, **{f"{folder}/{name}": content for name, content in information().items()}}
    record = "".join(record_line(name, content) for name, content in files.items()) + f"{folder}/RECORD,,\n"
    files[f"{folder}/RECORD"] = record.encode()
    name = f"actio-{described()[0]}-{tag()}.whl"
    with zipfile.ZipFile(os.path.join(directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, (2000, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, content)
    return name


# ---- What pip calls


def get_requires_for_build_wheel(config_settings=None):
    return []


get_requires_for_build_editable = get_requires_for_build_sdist = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = pathlib.Path(metadata_directory, information_folder())
    folder.mkdir()
    for name, content in information().items():
        (folder / name).write_bytes(content)
    return folder.name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = built(config_settings)
    compiled = [module(package), *sorted(package.glob("libactio_*.so"))]
    files = {f"actio/{path.name}": path.read_bytes() for path in [*sources(), *compiled]}
    return packed(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that points to the folder of the build; after an edit, building there is enough."""
    package = built(config_settings)
    return packed(wheel_directory, {"actio.pth": f"{package.parent}\n".encode()})


def tracked_files():
    """The files of the project: those that git knows; without git, all but what is built and what is
    hidden."""
    if (ROOT / ".git").exists() and shutil.which("git"):
        names = called("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard").split("\0")
        return sorted(name for name in names if name and (ROOT / name).is_file())
    found = []
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if not re.match(r"\.|build(-|$)|__pycache__$", name)]
        found += [
            os.path.relpath(os.path.join(folder, name), ROOT)
            for name in names
            if not name.startswith(".") and name != "PKG-INFO"
        ]
    return sorted(found)


def build_sdist(sdist_directory, config_settings=None):
    name = f"actio-{described()[0]}"
    with tempfile.NamedTemporaryFile("w", suffix="PKG-INFO") as information_, tarfile.open(
        os.path.join(sdist_directory, name + ".tar.gz"), "w:gz", format=tarfile.PAX_FORMAT
    ) as archive:
        information_.write(metadata())
        information_.flush()
        archive.add(information_.name, f"{name}/PKG-INFO")
        for path in tracked_files():
            archive.add(ROOT / path, f"{name}/{path}")
    return name + ".tar.gz"
