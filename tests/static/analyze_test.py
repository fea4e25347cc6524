# SPDX-License-Identifier: MIT
"""Sources that no compile database knows, planted in a tree of a test's own; and what is left out where there is no
cross compiler."""

import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "toolchains"))
import analyze  # noqa: E402

KNOWN = ("src/core/a.cpp", "port/platforms/host/b.cpp", "tests/unit/c_test.cpp")
BOARD = "port/platforms/mps2/uart.cpp"


class SourcesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.source = pathlib.Path(folder.name).resolve()
        self.build = self.source / "build"
        self.build.mkdir()
        for name in (*KNOWN, BOARD):
            self.plant(name)
        subprocess.run(["git", "init", "-q", str(self.source)], check=True)
        (self.source / ".gitignore").write_text("/build/\n")
        self.cross = [BOARD]

    def plant(self, name):
        path = self.source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("// SPDX-License-Identifier: MIT\n")

    def units(self, names, compiler):
        return [{"directory": str(self.build), "file": str(self.source / name),
                 "command": f"{compiler} -o x.obj -c {self.source / name}"} for name in names]

    def check(self, has_cross_compiler=True):
        """(whether it failed, what was told)"""
        (self.build / "compile_commands.json").write_text(json.dumps(self.units(KNOWN, "g++")))
        cross = self.units(self.cross, analyze.CROSS_COMPILER)
        told = io.StringIO()
        tools = {} if has_cross_compiler else {analyze.CROSS_COMPILER: None}
        with contextlib.ExitStack() as stack:
            stack.enter_context(contextlib.redirect_stdout(told))
            stack.enter_context(mock.patch.object(analyze.shutil, "which", lambda name: tools.get(name, name)))
            stack.enter_context(mock.patch.object(analyze, "for_clang", lambda command: command))
            if has_cross_compiler:
                stack.enter_context(mock.patch.object(analyze.Analysis, "cross_units", lambda _: cross))
            analysis = analyze.Analysis(self.source, self.build)
            analysis.check_sources()
        return bool(analysis.failed), told.getvalue()

    def test_a_tree_in_which_all_is_listed_passes(self):
        failed, told = self.check()
        self.assertFalse(failed, told)
        self.assertIn("sources: 4, of which 3 are analysed", told)

    def test_what_only_gcc_knows_is_not_told_to_clang(self):
        with mock.patch.object(self, "units", lambda names, _, units=self.units: units(names, "g++ --param=x-growth=4")):
            self.check()
        commands = [unit["command"] for unit in
                    json.loads((self.build / "analysis" / "compile_commands.json").read_text())]
        of_host = [command for command in commands if "mps2" not in command]  # a board's go through for_clang()
        self.assertTrue(of_host)
        self.assertFalse([command for command in of_host if "--param" in command])

    def test_one_in_no_database_is_noticed_wherever_it_is(self):
        for name in ("src/core/lost.cpp", "port/platforms/host/lost.cpp", "tests/unit/lost_test.cpp", "port/platforms/stm32f405/lost.cpp"):
            with self.subTest(name=name):
                self.plant(name)
                failed, told = self.check()
                (self.source / name).unlink()
                self.assertTrue(failed)
                self.assertIn(f"{name}: in no compile database", told)

    def test_one_of_a_board_that_the_cross_build_forgot_is_noticed(self):
        self.cross = []
        failed, told = self.check()
        self.assertTrue(failed)
        self.assertIn(f"{BOARD}: in no compile database", told)

    def test_what_is_not_of_the_tree_is_nobodys(self):
        self.plant("build/generated.cpp")
        failed, told = self.check()
        self.assertFalse(failed, told)

    def test_a_named_exception_is_none_of_a_neighbours(self):
        self.plant("tests/compile_fail/cases/wrong.cpp")
        failed, told = self.check()
        self.assertFalse(failed, told)
        self.plant("tests/compile_fail/other.cpp")
        self.assertTrue(self.check()[0])

    def test_without_a_cross_compiler_boards_are_left_out_plainly_and_nothing_else(self):
        failed, told = self.check(has_cross_compiler=False)
        self.assertFalse(failed, told)
        self.assertIn(f"LEFT OUT, for there is no {analyze.CROSS_COMPILER}", told)
        self.assertIn("port/platforms/mps2/", told)
        self.plant("port/platforms/host/lost.cpp")
        failed, told = self.check(has_cross_compiler=False)
        self.assertTrue(failed)
        self.assertIn("port/platforms/host/lost.cpp", told)

    def test_every_exception_is_still_there(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        for name in analyze.IN_NO_DATABASE:
            self.assertTrue((root / name).exists(), name)
        for name in analyze.CROSS_ONLY:
            self.assertTrue(list(root.glob(name.rstrip("/") + "*")), name)


class CommandTest(unittest.TestCase):
    def test_a_cross_command_is_clangs_with_the_boards_sizes_and_library(self):
        command = "arm-none-eabi-g++ -mcpu=cortex-m4 -O2 -fcallgraph-info=su,da -o a.obj -c a.cpp"
        with mock.patch.object(analyze, "search_path", lambda _: ["/cross/c++", "/cross/include"]):
            words = analyze.for_clang(command).split()
        self.assertEqual(words, ["clang++", analyze.CROSS_TARGET, "-nostdlibinc", "-mcpu=cortex-m4", "-O2", "-isystem",
                                 "/cross/c++", "-isystem", "/cross/include", "-o", "a.obj", "-c", "a.cpp"])


if __name__ == "__main__":
    unittest.main()
