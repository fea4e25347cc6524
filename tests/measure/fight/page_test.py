#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/fencing.md and the README beside this say of batuta-fight: each command runs, and its figures are the page's.

page_test.py PROGRAM SOURCE: the program, and the folder of the project
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = map(os.path.abspath, sys.argv[1:3])
HERE = os.path.join(SOURCE, "tests/measure/fight")
TIMEOUT_S = 600
# Of the README: what each command is run with here. A climb of one round with three tries changes no more than a copy.
WORDS = {
    "table": "table 3 1 keys.txt 12",
    "ripostes": "ripostes 1 1 keys.txt",
    "search": "search 3 1 1 keys.txt",
    "map": "map keys.txt",
    "figure": "figure map.svg",
}


def text_of(name):
    with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
        return file.read()


def run(words, folder=None):
    done = subprocess.run([PROGRAM, *words.split()], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=TIMEOUT_S, check=False)
    if done.returncode != 0:
        raise AssertionError("%s: exit code %d, %s" % (words, done.returncode, done.stderr))
    return done.stdout


def rows_of_page(page):
    """{name: the numbers of the row}"""
    rows = re.findall(r"^\| ([^|]+?) \| (.*) \|$", page, re.MULTILINE)
    return {name: [float(x) for x in re.findall(r"-?\d+(?:\.\d+)?", numbers)] for name, numbers in rows}


def rows_of_table(table):
    """The same, of what the program prints: a figure and its bound, or a figure for each line of the attack."""
    bounds = re.findall(r"^(\S.*?) +(-?[\d.]+)  [<>]= +(-?[\d.]+)", table, re.MULTILINE)
    shares = re.findall(r"^  (\S.*?)  +((?: *[\d.]+){4})  mean", table, re.MULTILINE)
    found = {name: [float(value), float(bound)] for name, value, bound in bounds}
    found.update({name: [float(x) for x in numbers.split()] for name, numbers in shares})
    return found


class PageTest(unittest.TestCase):
    page = text_of("docs/fencing.md")

    def test_its_commands_are_known(self):
        named = re.findall(r"`(?:build/host/tests/)?batuta-fight ([^`]+)`", self.page)
        self.assertEqual(sorted(named), ["figure", "map", "search", "table 200 2026"])

    def test_its_figures_are_printed(self):
        printed = rows_of_table(run("table 200 2026"))
        self.assertGreaterEqual(len(printed), 27)
        told = rows_of_page(self.page)
        for name, numbers in printed.items():
            self.assertIn(name, told)
            self.assertEqual(told[name], numbers, name)

    def test_the_map_is_that_of_the_source(self):
        self.assertIn(run("map").strip(), text_of("src/fencing/map_keys.hpp"))

    def test_the_picture_is_that_of_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            run("figure map.svg", folder)
            with open(os.path.join(folder, "map.svg"), encoding="utf-8") as drawn:
                self.assertEqual(drawn.read(), text_of("docs/fencing_map.svg"))

    def test_nothing_is_drawn_over_what_is_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "map.svg")
            with open(path, "w", encoding="utf-8") as printed:
                done = subprocess.run([PROGRAM, "figure", path], stdout=printed, stderr=subprocess.PIPE, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("it is what is printed to", done.stderr)

    def test_commands_of_the_readme_run(self):
        named = re.findall(r"`batuta-fight (\w+)[^`]*`", text_of("tests/measure/fight/README.md"))
        self.assertEqual(sorted(named), sorted(WORDS))
        with tempfile.TemporaryDirectory() as folder:
            for words in WORDS.values():
                shutil.copy(os.path.join(HERE, "keys.txt"), folder)
                run(words, folder)
            self.assertEqual(sorted(os.listdir(folder)), ["keys.txt", "map.svg"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
