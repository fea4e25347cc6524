# SPDX-License-Identifier: MIT
"""The committed part of the exact answers: what it is by itself and, where the whole files are there, that its rows are
rows of theirs, drawn by the rule of draw.py.

usage: draw_test.py WHOLE
"""
import collections
import csv
import os
import sys
import tempfile
import unittest

import draw

HERE = os.path.dirname(os.path.abspath(__file__))
WHOLE = sys.argv.pop()
FAMILIES = {
    "toc.csv": "generic fence60 fence1ms spin trans rot sphere sphcap nearpar par cross grazehit grazemiss touch slight"
               " deep separate tiny huge far thin fat ratio still tzero denorm".split(),
    "dist.csv": "random pointpoint pointseg same collinear par nearpar tee meet close inner tiny huge far"
                " ratio".split(),
    "resp.csv": "sword capsule massratio infinite central e01 aniso far apart bothinf graze".split(),
}


def rows_of(name):
    return list(csv.DictReader(draw.read_lines(os.path.join(HERE, name))))


class Part(unittest.TestCase):
    def test_it_has_its_number_of_rows_each_once(self):
        for name, number in draw.ROWS.items():
            lines = draw.read_lines(os.path.join(HERE, name))
            self.assertEqual(len(lines), number + 1, name)
            self.assertEqual(len(set(lines)), number + 1, name)

    def test_it_has_rows_of_every_family(self):
        for name, families in FAMILIES.items():
            count = collections.Counter(row["family"] for row in rows_of(name))
            self.assertEqual(sorted(count), sorted(families), name)
            self.assertGreaterEqual(min(count.values()), 9, count)

    def test_times_have_every_outcome(self):
        count = collections.Counter(row["kind"] for row in rows_of("toc.csv"))
        self.assertEqual(sorted(count), ["0", "1", "2"])
        self.assertGreater(min(count.values()), 100, count)

    def test_distances_have_every_class(self):
        self.assertEqual({row["cls"] for row in rows_of("dist.csv")}, {"0", "1", "2"})
        self.assertEqual({row["unique"] for row in rows_of("dist.csv")}, {"0", "1"})


class Rule(unittest.TestCase):
    def test_parts_are_in_proportion_and_add_up(self):
        self.assertEqual(draw.quotas({"a": 60, "b": 30, "c": 10}, 10), {"a": 6, "b": 3, "c": 1})
        self.assertEqual(draw.quotas({"a": 1, "b": 1, "c": 1}, 2), {"a": 1, "b": 1, "c": 0})

    def test_spaced_rows_are_at_equal_distances(self):
        self.assertEqual(draw.spaced(list(range(100, 110)), 5), {100, 102, 104, 106, 108})

    def test_bits_are_a_float(self):
        self.assertEqual([draw.number(bits) for bits in ("3f8", "0", "c")], [1, 0, -2])


@unittest.skipUnless(os.path.isdir(WHOLE), f"there is no {WHOLE}: whether the part is of it cannot be seen")
class OfTheWhole(unittest.TestCase):
    def test_its_lines_are_lines_of_the_whole_in_their_order(self):
        for name in draw.ROWS:
            whole = iter(draw.read_lines(os.path.join(WHOLE, name)))
            for line in draw.read_lines(os.path.join(HERE, name)):
                self.assertIn(line, whole)  # takes from the iterator what comes before the line

    def test_it_is_what_the_rule_draws(self):
        self.assertEqual(draw.main(["--check", WHOLE, HERE]), 0)

    def test_one_other_digit_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(draw.main([WHOLE, folder]), 0)
            path = os.path.join(folder, "dist.csv")
            lines = draw.read_lines(path)
            lines[7] = lines[7].replace("1", "2", 1)
            with open(path, "w", encoding="ascii", newline="") as file:
                file.writelines(lines)
            self.assertEqual(draw.main(["--check", WHOLE, folder]), 1)


if __name__ == "__main__":
    unittest.main()
