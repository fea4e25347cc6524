#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ways in which a CMake project takes the library, configured; what is fetched is built as far as one room: as a subfolder and by FetchContent, with Eigen as a target, a
package or a folder, for this machine and for a board. What CMake does meanwhile is read from its own trace: it looks for nothing but Eigen,
makes no program and no test, and reads no file that static.CMake_IsThatOfUsers does not look at.
Usage: ways_test.py SOURCE_FOLDER EIGEN. Without arm-none-eabi-g++ what is said of a board is skipped, with a line."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, EIGEN = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
sys.path[:0] = [str(SOURCE / "tests/static"), str(SOURCE / "toolchains/packages")]
import archives  # noqa: E402
import check_cmake  # noqa: E402
import project as names  # noqa: E402

TARGET = """add_library(eigen INTERFACE)
add_library(Eigen3::Eigen ALIAS eigen)
target_include_directories(eigen SYSTEM INTERFACE {eigen})
"""
SUBFOLDER = "add_subdirectory({source} batuta)\n"
FETCHED = """include(FetchContent)
FetchContent_Declare(batuta URL {archive})
FetchContent_MakeAvailable(batuta)
"""
BOARD = """set(CMAKE_SYSTEM_NAME PICO)
set(CMAKE_SYSTEM_PROCESSOR cortex-m0plus)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
"""
NO_PACKAGE = "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON"
MAKES_NO = {"add_executable", "add_test", "enable_testing", "pkg_check_modules", "gtest_discover_tests"}
ONE_ROOM = """add_executable(one_room {source}/tests/consumer/project/main.cpp {source}/tests/consumer/project/own_trap.cpp)
target_link_libraries(one_room PRIVATE batuta::geometry)
"""


class Configured:
    """A project of a few lines that links batuta::batuta, and what CMake did for it. `build` names a program that is then built and run."""

    def __init__(self, lines, *words, source=SOURCE, build=""):
        with tempfile.TemporaryDirectory(prefix="batuta-way-") as name:
            folder = pathlib.Path(name)
            archive = ""
            if "{archive}" in lines:
                project = names.read_project(SOURCE)
                archive = folder / "made" / archives.make(project, folder / "made")[0]
            head = "cmake_minimum_required(VERSION 3.16)\nproject(way LANGUAGES CXX)\n"
            body = lines.format(source=source, eigen=EIGEN, archive=archive)
            (folder / "CMakeLists.txt").write_text(
                head + body + "add_library(own STATIC own.cpp)\ntarget_link_libraries(own PRIVATE batuta::batuta)\n", encoding="utf-8")
            (folder / "own.cpp").write_text('#include "batuta/world/world.hpp"\n', encoding="utf-8")
            (folder / "board.cmake").write_text(BOARD, encoding="utf-8")
            trace = folder / "trace"
            words = [word.format(folder=folder, eigen=EIGEN) for word in words]
            done = subprocess.run(["cmake", "-S", name, "-B", f"{name}/build", "-G", "Ninja", "--trace-format=json-v1",
                                   f"--trace-redirect={trace}", *words], capture_output=True, text=True, check=False)
            self.code, self.told = done.returncode, " ".join((done.stdout + done.stderr).split())
            cache = folder / "build/CMakeCache.txt"
            self.cache = dict(re.findall(r"^(\w+):\w+=(.*)$", cache.read_text(encoding="utf-8"), re.M)) if cache.exists() else {}
            self.ran = self.build(f"{name}/build", build) if build and self.code == 0 else ""
            self.calls = [json.loads(line) for line in trace.read_text(encoding="utf-8").splitlines()[1:]]

    @staticmethod
    def build(tree, program):
        """What was wrong with a program that is built and run, or nothing."""
        for words in (["cmake", "--build", tree, "--target", program], [f"{tree}/{program}"]):
            done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode:
                return f"{words}: {done.returncode}\n{done.stdout[-3000:]}"
        return ""

    def own_calls(self):
        """Calls in files of the library, whether it is the tree itself or a copy that was fetched: (file below its root, command, words)."""
        for call in self.calls:
            found = re.match(rf"(?:{re.escape(str(SOURCE))}|.*/_deps/batuta-src)/(.*)", call["file"])
            if found and "/_deps/batuta-build" not in call["file"]:
                yield found.group(1), call["cmd"].lower(), call["args"]


class Ways(unittest.TestCase):
    def expect_lean(self, way, packages):
        self.assertEqual(way.code, 0, way.told[-3000:])
        own = list(way.own_calls())
        self.assertGreater(len(own), 100)
        looked_at = {path.relative_to(SOURCE).as_posix() for path in check_cmake.read_by_users(SOURCE)}
        self.assertEqual({file for file, _, _ in own} - looked_at, set(), "read by users, and static.CMake_IsThatOfUsers does not look")
        self.assertEqual({command for _, command, _ in own} & MAKES_NO, set())
        self.assertEqual([words[0] for _, command, words in own if command == "find_package"], packages)

    def test_subfolder_with_eigen_as_a_target(self):
        self.expect_lean(Configured(TARGET + SUBFOLDER, NO_PACKAGE), [])

    def test_install_rules_with_eigen_as_a_target(self):
        way = Configured(TARGET + SUBFOLDER, NO_PACKAGE, "-DBATUTA_INSTALL=ON")
        self.assertEqual(way.code, 0, way.told[-3000:])

    def test_own_port_with_a_slash_behind_its_path(self):
        way = Configured(TARGET + SUBFOLDER, NO_PACKAGE, f"-DBATUTA_PORT={SOURCE}/port/template/")
        self.assertEqual(way.code, 0, way.told[-3000:])

    def test_subfolder_with_eigen_as_a_package(self):
        self.expect_lean(Configured(SUBFOLDER), ["Eigen3"])

    def test_subfolder_with_eigen_as_a_folder(self):
        way = Configured(SUBFOLDER, NO_PACKAGE, "-DBATUTA_EIGEN_PATH={eigen}")
        self.expect_lean(way, [])
        self.assertEqual(way.cache["BATUTA_WITH_DOUBLE"], "ON")
        self.assertEqual(way.cache["BATUTA_PORT"], "host")

    def test_msvc_gets_flags_that_it_has(self):
        flags = {}
        for msvc in ("OFF", "ON"):  # the variable alone: there is no such compiler here
            way = Configured(TARGET + SUBFOLDER, NO_PACKAGE, f"-DMSVC={msvc}")
            self.assertEqual(way.code, 0, way.told[-3000:])
            flags[msvc] = {word for file, command, words in way.own_calls() if file == "src/CMakeLists.txt"
                           and command == "target_compile_options" for word in words if word[0] in "-/"}
        self.assertIn("-ffp-contract=off", flags["OFF"])
        self.assertIn("/fp:precise", flags["ON"])
        self.assertEqual({word for word in flags["OFF"] if word[0] == "/"} | {word for word in flags["ON"] if word[0] == "-"}, set())

    def test_a_folder_without_eigen_is_told(self):
        way = Configured(SUBFOLDER, "-DBATUTA_EIGEN_PATH={folder}")
        self.assertNotEqual(way.code, 0)
        self.assertIn("there is no Eigen/Core in that folder", way.told)

    def test_fetched(self):
        way = Configured(TARGET + FETCHED + ONE_ROOM, NO_PACKAGE, "-DBATUTA_UNITY_ROOMS=ON", "-DBATUTA_WITH_DOUBLE=OFF", build="one_room")
        self.expect_lean(way, [])
        self.assertEqual(way.ran, "")

    @unittest.skipUnless(shutil.which("arm-none-eabi-g++"), "no arm-none-eabi-g++ (toolchains/setup.sh target)")
    def test_a_board_whose_toolchain_has_a_name_of_its_own(self):
        way = Configured(TARGET + SUBFOLDER, NO_PACKAGE, "-DCMAKE_TOOLCHAIN_FILE={folder}/board.cmake")
        self.expect_lean(way, [])
        self.assertEqual(way.cache["BATUTA_WITH_DOUBLE"], "OFF", "double on bare metal")
        self.assertEqual(way.cache["BATUTA_PORT"], "", "a port that nobody chose")
        self.assertFalse([file for file, _, _ in way.own_calls() if file.startswith("port/platforms/host/")])

    @unittest.skipUnless(shutil.which("arm-none-eabi-g++"), "no arm-none-eabi-g++ (toolchains/setup.sh target)")
    def test_the_hosts_port_is_not_for_a_board(self):
        way = Configured(TARGET + SUBFOLDER, NO_PACKAGE, "-DCMAKE_TOOLCHAIN_FILE={folder}/board.cmake", "-DBATUTA_PORT=host")
        self.assertNotEqual(way.code, 0)
        self.assertIn("BATUTA_PORT=host is for the machine that builds", way.told)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
