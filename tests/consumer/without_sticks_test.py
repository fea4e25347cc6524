#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The whole project is configured where evemu and libevdev are not found, as on macOS: what needs them is left out with a line, and nothing
that is left links it. Who asks for batuta-duel alone is told that it cannot be had. Usage: without_sticks_test.py SOURCE_FOLDER"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
TOLD = "batuta-duel is left out: its sticks are read by evemu and libevdev, which were not found"


def configure(*words):
    """Exit code, what was said, and Ninja's file."""
    with tempfile.TemporaryDirectory(prefix="batuta-no-sticks-") as folder:
        done = subprocess.run(["cmake", "-S", str(SOURCE), "-B", folder, "-G", "Ninja", *words], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False,
                              env={**os.environ, "PKG_CONFIG_LIBDIR": folder, "PKG_CONFIG_PATH": folder})
        file = pathlib.Path(folder, "build.ninja")
        return done.returncode, " ".join(done.stdout.split()), file.read_text(encoding="utf-8") if file.exists() else ""


class WithoutSticks(unittest.TestCase):
    def test_all_but_what_needs_them(self):
        code, told, ninja = configure("-DBATUTA_BUILD_TESTS=ON")
        self.assertEqual(code, 0, told[-3000:])
        self.assertIn(TOLD, told)
        programs = {name for name in ("answer", "mass", "feel", "duel") if re.search(rf"(?m)^build batuta-{name}:", ninja)}
        self.assertEqual(programs, {"answer", "mass", "feel"})
        self.assertIn("batuta_test_geometry", ninja)
        self.assertEqual(set(re.findall(r"-l(batuta_\w+)", ninja)), set(), "linked, and no target")

    def test_the_duel_alone(self):
        code, told, _ = configure("-DBATUTA_ONLY_DUEL=ON", "-DBATUTA_BUILD_TESTS=OFF")
        self.assertNotEqual(code, 0)
        self.assertIn(TOLD, told)
        self.assertIn("batuta-duel cannot be built without what is said above", told)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
