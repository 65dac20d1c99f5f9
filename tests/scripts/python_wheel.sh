#!/usr/bin/env bash
# python_wheel.sh SOURCE BUILD PYTHON: `pip install` makes a wheel of the module that is in BUILD and puts it
# into a fresh environment, from which it is imported and runs a scene; no package is fetched. Without pip the
# test is skipped.
set -euo pipefail
source=$1
build=$2
python=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

if ! "$python" -m pip --version >/dev/null 2>&1 || ! "$python" -c 'import venv' 2>/dev/null; then
  echo "skipped: $python has no pip or no venv (Debian: python3-pip python3-venv)"
  exit 77
fi
fail() { printf '%s\n' "$1" >&2; exit 1; }
pip() {
  PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1 "$python" -m pip --quiet --python "$scratch/venv/bin/python" "$@"
}

"$python" -m venv --system-site-packages --without-pip "$scratch/venv"
pip install --config-settings "build-folder=$build" "$source" || fail "pip install failed"

# What was installed is what is imported, wherever one stands, and runs.
cd "$scratch"
unset PYTHONPATH
cat >try.py <<'TRY'
import base64, hashlib, pathlib, sys, warnings
from importlib import metadata
import actio
assert pathlib.Path(actio.__file__).is_relative_to(sys.prefix), actio.__file__
assert pathlib.Path(actio.__file__).with_name("py.typed").exists()
assert metadata.version("actio") == actio.__version__
files = {str(file) for file in metadata.files("actio")}
assert {"actio/__init__.py", "actio/_actio.pyi", "actio/py.typed", "actio/libactio_hdf5.so"} <= files, files
for file in metadata.files("actio"):
    if file.hash:
        digest = hashlib.sha256(file.locate().read_bytes()).digest()
        assert base64.urlsafe_b64encode(digest).rstrip(b"=").decode() == file.hash.value, file
scene = {"system": {"kind": "rigid_body", "body": "t_handle"}, "initial.angular_velocity": [10, 0.001, 0.01]}
run = actio.run(scene, set={"run.until": 1, "output.quantities": ["energy"]})
assert run.rows == 2
# A module that it loads lies beside it.
warnings.simplefilter("ignore")
changes = {"run.until": 1, "output.quantities": ["energy"], "output.formats": ["hdf5"]}
actio.run(scene, set=changes).save("saved")
assert pathlib.Path("saved/series.h5").exists()
print("installed", actio.__version__)
TRY
"$scratch/venv/bin/python" try.py

# The same files make the same wheel; one without what it needs is refused in a sentence.
cat >again.py <<'TRY'
import pathlib, sys, tarfile
source, build = sys.argv[1:]
sys.path.insert(0, source + "/cmake/python")
import actio_wheel
names = []
for folder in ["one", "other"]:
    pathlib.Path(folder).mkdir()
    names.append(f"{folder}/{actio_wheel.build_wheel(folder, {'build-folder': build})}")
assert pathlib.Path(names[0]).read_bytes() == pathlib.Path(names[1]).read_bytes()
with tarfile.open(actio_wheel.build_sdist(".")) as archive:
    files = {name.partition("/")[2] for name in archive.getnames()}
assert {"PKG-INFO", "pyproject.toml", "CMakeLists.txt", "src/python/actio/__init__.py", "cmake/python/actio_wheel.py"} <= files
assert not any(name.startswith(("build/", ".git/")) for name in files)
actio_wheel.sysconfig.get_path = lambda name: "/nowhere"
actio_wheel.build_wheel(".")
TRY
said=$("$python" again.py "$source" "$build" 2>&1) && fail "it built without headers"
grep -q '^actio cannot be built: the headers of .* are not there: /nowhere/Python.h' <<<"$said" || fail "$said"

pip uninstall --yes actio >/dev/null
"$scratch/venv/bin/python" -c 'import actio' 2>/dev/null && fail "uninstalling leaves the package"
true
