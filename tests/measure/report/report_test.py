#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a section of the report at its smallest size, whole and in three shards: the files parse, are not empty, and the
merged shards are the whole in every column that does not hold times. Then its page is drawn, and the pictures are
well-formed. Usage: report_test.py PROGRAM"""

import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import rows

HERE = pathlib.Path(__file__).resolve().parent
SHARDS = 3
MOST_SECONDS = 20  # of a processor; the longest took 7


def run(program, folder, *options):
    subprocess.run([program, "--out", str(folder), "--mode", "tiny", *options], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


def comparable(table):
    """Rows by their keys, without times."""
    keys = [name for name, kind in table.kinds.items() if not kind]
    data = [name for name, kind in table.kinds.items() if kind and not name.startswith("time")]
    return {tuple(row[name] for name in keys): {name: row[name] for name in data} for row in table.rows}


class Section(unittest.TestCase):
    maxDiff = 2000

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run(PROGRAM, cls.folder / "whole")
        cls.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        for shard in range(1, SHARDS + 1):
            run(PROGRAM, cls.folder / "shards", "--shard", f"{shard}/{SHARDS}")
        cls.files = sorted(path.name for path in (cls.folder / "whole").glob("*.csv"))

    def test_smallest_size_is_small(self):
        """Also on a host that is busy with other tests: no time is measured again until it is calm."""
        self.assertLess(self.seconds, MOST_SECONDS)

    def test_merged_shards_are_the_whole(self):
        self.assertTrue(self.files)
        for name in self.files:
            merged = self.folder / f"merged-{name}"
            parts = sorted((self.folder / "shards").glob(f"{name.removesuffix('.csv')}.*-of-{SHARDS}.csv"))
            self.assertEqual(len(parts), SHARDS)
            subprocess.run([sys.executable, "-B", HERE / "merge.py", "--out", merged, *parts], check=True)
            whole = rows.Rows.read(self.folder / "whole" / name)
            self.assertTrue(whole.rows)
            self.assertEqual(list(rows.Rows.read(merged).kinds.items()), list(whole.kinds.items()))
            self.assertEqual(comparable(rows.Rows.read(merged)), comparable(whole.merged()), name)

    def test_pictures_are_drawn(self):
        folder = self.folder / "whole"
        subprocess.run([sys.executable, "-B", HERE / "render.py", folder], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        report = (folder / "report.md").read_text()
        own = [part for part in report.split("\n## ")[1:] if "*Not in this report" not in part]
        self.assertEqual(len(own), 1)
        pictures = re.findall(r"!\[[^]]*\]\(([^)]+\.svg)\)", own[0])
        self.assertTrue(pictures or not shutil.which("gnuplot"))
        for picture in pictures:
            self.assertTrue(len(xml.etree.ElementTree.parse(folder / picture).getroot()), picture)

    def test_bad_use_exits_with_two(self):
        for words in (["--mode", "none"], ["--shard", "2/1"], ["--nonsense"]):
            done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(len(done.stderr.splitlines()), 1)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
