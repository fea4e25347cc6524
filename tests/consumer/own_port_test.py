#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`cmake --install` with a port of one's own, and with none: what ports share comes with its headers, and a project links it.
Usage: own_port_test.py SOURCE_FOLDER EIGEN"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, EIGEN = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
LEAN = ["-DBATUTA_BUILD_TESTS=OFF", "-DBATUTA_BUILD_EXAMPLES=OFF", "-DBATUTA_BUILD_PROGRAMS=OFF", "-DBATUTA_WITH_DOUBLE=OFF",
        "-DBATUTA_UNITY_ROOMS=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON", f"-DBATUTA_EIGEN_PATH={EIGEN}"]
USER = """cmake_minimum_required(VERSION 3.16)
project(user LANGUAGES CXX)
find_package(batuta REQUIRED)
add_executable(user {source}/tests/consumer/project/link.cpp {own})
target_link_libraries(user PRIVATE batuta::link {port})
"""


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout[-3000:]}")


def build(source, tree, targets, *words):
    run("cmake", "-S", source, "-B", tree, "-G", "Ninja", *words)
    run("cmake", "--build", tree, "--target", *targets)


def install(tree, prefix):
    """What was not built, because nobody links it here, is an empty file."""
    for name in re.findall(r'"([^"]+[.]a)"', (tree / "cmake_install.cmake").read_text(encoding="utf-8")):
        if name.startswith(str(tree)) and not pathlib.Path(name).exists():
            pathlib.Path(name).touch()
    run("cmake", "--install", tree, "--prefix", prefix)


class OwnPort(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="batuta-own-port-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def expect_link(self, port, targets, linked, own=""):
        build(SOURCE, self.folder / "tree", targets, f"-DBATUTA_PORT={port}", *LEAN)
        install(self.folder / "tree", self.folder / "prefix")
        told = {path.relative_to(SOURCE / "port").as_posix() for path in (SOURCE / "port/shared").rglob("*.hpp")}
        base = self.folder / "prefix/include/batuta-port"
        self.assertEqual(told - {path.relative_to(base).as_posix() for path in base.rglob("*.hpp")}, set())
        user = self.folder / "user"
        user.mkdir()
        (user / "CMakeLists.txt").write_text(USER.format(source=SOURCE, port=linked, own=own), encoding="utf-8")
        build(user, self.folder / "built", ["user"], f"-DCMAKE_PREFIX_PATH={self.folder}/prefix", f"-DBATUTA_EIGEN_PATH={EIGEN}",
              "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON")
        run(self.folder / "built/user")

    def test_a_folder_elsewhere(self):
        shutil.copytree(SOURCE / "port/template", self.folder / "own/template")
        self.expect_link(self.folder / "own/template", ["batuta_link", "batuta_port_template"], "batuta::port_template")

    def test_none(self):
        self.expect_link("", ["batuta_link"], "", SOURCE / "tests/consumer/project/own_trap.cpp")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
