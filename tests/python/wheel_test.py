#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The Python package as a user gets it: a wheel from the tree, without a network; installed; asked.
Usage: wheel_test.py SOURCE EIGEN WORK VECTORS. Exit code 77: skipped, for want of a module."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

SOURCE, EIGEN, WORK, VECTORS = (pathlib.Path(word).resolve() for word in sys.argv[1:])
SKIPPED = 77
PACKAGE = SOURCE / "port" / "python"
HERE = pathlib.Path(__file__).resolve().parent


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def run(*words, **more):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **more)
    check(result.returncode == 0, f"{words}\n{result.stdout[-4000:]}\n{result.stderr[-8000:]}")
    return result.stdout + result.stderr


def files_of(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


def main():
    missing = [name for name in ("numpy", "pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]
    if missing:
        print(f"skipped: {sys.executable} has no {', '.join(missing)}; see toolchains/setup.sh packages")
        return SKIPPED
    before = files_of(PACKAGE)
    shutil.rmtree(WORK / "built" / "setuptools", ignore_errors=True)
    # The library stays, so that it is compiled anew only where it has changed; the rest begins with nothing.
    env = {**os.environ, "BATUTA_PYTHON_BUILD": str(WORK / "built"), "BATUTA_EIGEN_PATH": str(EIGEN), "PIP_NO_INDEX": "1",
           "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pip = [sys.executable, "-m", "pip"]
        run(*pip, "wheel", "--no-build-isolation", "--no-deps", "--no-cache-dir", "-w", folder / "wheel", PACKAGE, env=env)
        check(files_of(PACKAGE) == before, f"the build leaves files in the tree: {set(files_of(PACKAGE)) - set(before)}")
        wheels = list((folder / "wheel").iterdir())
        check(len(wheels) == 1 and "-py3-none-" in wheels[0].name, wheels)
        inside = sorted(path for path in zipfile.ZipFile(wheels[0]).namelist() if path.startswith("batuta/"))
        modules = [f"batuta/{path.name}" for path in (PACKAGE / "batuta").glob("*.py")]
        check([path for path in inside if path.endswith(".py")] == sorted(modules), inside)
        check(sum("libbatuta_queries." in path for path in inside) == 1 and len(inside) == len(modules) + 1, inside)
        with zipfile.ZipFile(wheels[0]) as wheel:
            licences = [wheel.read(path) for path in wheel.namelist() if path.endswith(".dist-info/LICENSE")]
        check(licences == [(SOURCE / "LICENSE").read_bytes()], "the wheel has not the library's licence, or not once")
        run(*pip, "install", "--no-deps", "--target", folder / "installed", wheels[0], env=env)
        told = run(sys.executable, "-B", HERE / "package_test.py", SOURCE, VECTORS, cwd=folder,
                   env={**os.environ, "PYTHONPATH": str(folder / "installed"), "PYTHONWARNINGS": "error"})
        print(told)
        check("OK" in told.splitlines()[-1], "package_test.py ran no test")
    return 0


if __name__ == "__main__":
    sys.exit(main())
