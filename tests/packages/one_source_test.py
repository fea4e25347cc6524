#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds that put all sources of the library into one file: it compiles, with the rooms in their order and the other way round. Names that
two sources share, or a namespace `detail` that hides another one, are found so.
Usage: one_source_test.py SOURCE_FOLDER EIGEN COMPILER"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE, EIGEN, COMPILER = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
sys.path.insert(0, str(SOURCE / "toolchains/packages"))
import project as names  # noqa: E402

PROJECT = names.read_project(SOURCE)
FLAGS = [*PROJECT.flags, *(f"-D{word}" for word in PROJECT.core_definitions), "-DBATUTA_WITH_DOUBLE=0", "-fsyntax-only",
         f"-I{SOURCE}/include", "-isystem", EIGEN]


def errors_of(sources, planted=""):
    """The compiler's errors about one file that includes these."""
    with tempfile.TemporaryDirectory(prefix="batuta-one-source-") as folder:
        file = pathlib.Path(folder, "all.cpp")
        file.write_text("".join(f'#include "{SOURCE}/{source}"\n' for source in sources) + planted, encoding="utf-8")
        done = subprocess.run([COMPILER, *FLAGS, str(file)], capture_output=True, text=True, check=False)
    return [line for line in done.stderr.splitlines() if "error:" in line] or ([done.stderr] if done.returncode else [])


class OneSource(unittest.TestCase):
    def test_in_the_order_of_rooms(self):
        self.assertGreater(len(PROJECT.sources()), 70)
        self.assertEqual(errors_of(PROJECT.sources()), [])

    def test_the_other_way_round(self):
        self.assertEqual(errors_of(PROJECT.sources()[::-1]), [])

    def test_a_name_that_two_have_is_found(self):
        planted = "namespace batuta { int crc32; }\n"
        self.assertTrue(errors_of(["src/core/crc32.cpp"], planted))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
