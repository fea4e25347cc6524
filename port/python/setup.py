# SPDX-License-Identifier: MIT
"""Builds the package from the tree that it stands in: the shared library by CMake (CMakeLists.txt), which finds Eigen as always
(BATUTA_EIGEN_PATH may be given in the environment), then a wheel for this platform and any Python 3. What is built on the way goes to
build/python of the tree, or to the folder that BATUTA_PYTHON_BUILD names."""

import os
import pathlib
import re
import shutil
import subprocess

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

try:
    from wheel.bdist_wheel import bdist_wheel
except ImportError:  # newer tools have it here
    from setuptools.command.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WORK = pathlib.Path(os.environ.get("BATUTA_PYTHON_BUILD", ROOT / "build" / "python"))


def version():
    return re.search(r"\bproject\(batuta VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


class BuildWithLibrary(build_py):
    """The modules, and the shared library beside them."""

    def run(self):
        super().run()
        tree = WORK / "cmake"
        configure = ["cmake", "-S", str(HERE), "-B", str(tree), "-DCMAKE_BUILD_TYPE=Release"]
        if "BATUTA_EIGEN_PATH" in os.environ:
            configure.append("-DBATUTA_EIGEN_PATH=" + os.environ["BATUTA_EIGEN_PATH"])
        subprocess.run(configure, check=True)
        os.environ.setdefault("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", str(tree), "--config", "Release", "--target", "batuta_python"], check=True)
        built = [path for path in tree.glob("**/libbatuta_queries.*") if path.suffix in (".so", ".dll", ".dylib")]
        if len(built) != 1:
            raise SystemExit(f"the shared library: {built}")
        self.copy_file(str(built[0]), str(pathlib.Path(self.build_lib) / "batuta" / built[0].name))


class WheelOfPlatform(bdist_wheel):
    """For any Python 3, and this platform: the shared library knows nothing of Python."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])

    def egg2dist(self, egginfo_path, distinfo_path):
        super().egg2dist(egginfo_path, distinfo_path)
        shutil.copy(ROOT / "LICENSE", distinfo_path)  # two folders above: setuptools would not look there


class DistributionOfPlatform(Distribution):
    def has_ext_modules(self):
        return True


WORK.mkdir(parents=True, exist_ok=True)
setup(version=version(), distclass=DistributionOfPlatform,
      cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": WheelOfPlatform},
      options={"build": {"build_base": str(WORK / "setuptools")}, "egg_info": {"egg_base": str(WORK)}})
