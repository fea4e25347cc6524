#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program that measures tells its usage and what it could not write: program_test.py PROGRAM [figure]."""

import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]
DRAWS = "figure" in sys.argv[2:]
USAGE = "usage: %s " % os.path.basename(PROGRAM)


def run(*words, **options):
    return subprocess.run([PROGRAM, *words], stderr=subprocess.PIPE, text=True, timeout=600, check=False,
                          **{"stdout": subprocess.PIPE, **options})


class ProgramTest(unittest.TestCase):
    def test_usage(self):
        asked = run("--help")
        self.assertEqual((asked.returncode, asked.stderr), (0, ""))
        self.assertTrue(asked.stdout.startswith(USAGE), asked.stdout)
        wrong = run()
        self.assertEqual((wrong.returncode, wrong.stdout), (2, ""))
        self.assertIn(USAGE, wrong.stderr)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no full device")
    def test_what_is_lost_is_told(self):
        with open("/dev/full", "wb") as full:
            lost = run("--help", stdout=full)
        self.assertEqual(lost.returncode, 1)
        self.assertIn("the output cannot be written", lost.stderr)

    @unittest.skipUnless(DRAWS, "it draws nothing")
    def test_a_picture_takes_its_place_when_it_is_whole(self):
        with tempfile.TemporaryDirectory() as folder:
            place = os.path.join(folder, "map.svg")
            other = os.path.join(folder, "other.svg")
            with open(place, "w", encoding="ascii") as file:
                file.write("an older picture")
            os.link(place, other)
            self.assertEqual(run("figure", place).returncode, 0)
            self.assertEqual(sorted(os.listdir(folder)), ["map.svg", "other.svg"])
            with open(place, encoding="utf-8") as new, open(other, encoding="ascii") as old:
                self.assertTrue(new.read().rstrip().endswith("</svg>"))
                self.assertEqual(old.read(), "an older picture", "it was written beside its place")
            nowhere = run("figure", os.path.join(folder, "none", "map.svg"))
            self.assertEqual(nowhere.returncode, 2)
            self.assertIn("cannot be written", nowhere.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
