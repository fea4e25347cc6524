# SPDX-License-Identifier: MIT
import os
import tempfile
import unittest

import hashes


class Reading(unittest.TestCase):
    def test_records_in_order(self):
        content = hashes.RECORD.pack(0, 7, 1 << 63) + hashes.RECORD.pack(5, (2 << 24) + 9, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hashes")
            with open(path, "wb") as file:
                file.write(content)
            self.assertEqual(hashes.read(path), [("toc", 7, 1 << 63), ("duel", (2 << 24) + 9, 3)])

    def test_counts(self):
        tally = hashes.counts([("toc", 1, 0), ("toc", 2, 0), ("flight", 0, 0)])
        self.assertEqual((tally["toc"], tally["flight"], tally["duel"]), (2, 1, 0))


class FirstDifference(unittest.TestCase):
    records = [("toc", 1, 10), ("toc", 2, 20), ("duel", 0, 30)]

    def test_of_the_same(self):
        self.assertIsNone(hashes.first_difference(self.records, list(self.records)))

    def test_one_hash(self):
        other = [("toc", 1, 10), ("toc", 2, 21), ("duel", 0, 31)]
        self.assertEqual(hashes.first_difference(self.records, other), ("toc", 2))

    def test_one_missing_at_the_end(self):
        self.assertEqual(hashes.first_difference(self.records, self.records[:2]), ("duel", 0))
        self.assertEqual(hashes.first_difference(self.records[:2], self.records), ("duel", 0))

    def test_one_missing_between(self):
        self.assertEqual(hashes.first_difference(self.records, self.records[1:]), ("toc", 1))

    def test_none_at_all(self):
        self.assertEqual(hashes.first_difference(self.records, []), ("toc", 1))


class Names(unittest.TestCase):
    def test_of_a_line(self):
        self.assertEqual(hashes.name_of("impulse", 12), "impulse, line 12")

    def test_of_a_sequence(self):
        self.assertEqual(hashes.name_of("duel", (2 << 24) + 345), "duel, recording 2, step 345")


class FirstField(unittest.TestCase):
    def test_of_the_same(self):
        self.assertIsNone(hashes.first_field(["gap 0"], ["gap 0"]))

    def test_bits(self):
        self.assertEqual(hashes.first_field(["s 1", "gap 2"], ["s 1", "gap 3"]), (1, "gap 2", "gap 3"))

    def test_length(self):
        self.assertEqual(hashes.first_field(["s 1"], ["s 1", "gap 3"]), (1, "(nothing)", "gap 3"))


if __name__ == "__main__":
    unittest.main()
