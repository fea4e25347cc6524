#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of merging and drawing that need no section's program."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import markdown
import merge
import readme
import render
import rows
import run

HEADER = "family,queries:sum,worst:max,least:min,cost:hist\n"


class Files(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def call(self, main, *words):
        said = io.StringIO()
        with mock.patch.object(sys, "argv", ["program", *words]), contextlib.redirect_stderr(said), \
                contextlib.redirect_stdout(io.StringIO()):
            code = main()
        return code, said.getvalue()

    def test_merge_adds_sums_and_bins_and_keeps_extremes(self):
        first = self.write("1.csv", HEADER + "a,2,0.5,,3:1 7:2\nb,1,,2,\n")
        second = self.write("2.csv", HEADER + "a,40,0.25,-1,7:1\nc,1,1e-300,1,0:1\n")
        out = str(self.folder / "out.csv")
        self.assertEqual(self.call(merge.main, "--out", out, first, second), (0, ""))
        self.assertEqual(pathlib.Path(out).read_text(),
                         HEADER + "a,42,0.5,-1.0,3:1 7:3\nb,1,,2.0,\nc,1,1e-300,1.0,0:1\n")

    def test_merge_refuses_files_that_do_not_belong_together(self):
        first = self.write("1.csv", HEADER)
        for text in ("family,queries:sum\na,1\n", HEADER + "a,1\n", "a:mean\n", ""):
            second = self.write("2.csv", text)
            code, said = self.call(merge.main, "--out", str(self.folder / "out.csv"), first, second)
            self.assertEqual(code, 1)
            self.assertTrue(said.startswith("merge.py: "))

    def test_percentages_show_every_digit_before_the_point(self):
        shares = [(0, 7), (1, 1), (996, 1000), (99, 1000), (1, 3000), (12, 1), (3, 0)]
        self.assertEqual([markdown.share(*pair) for pair in shares],
                         ["0", "100 %", "100 %", "9.9 %", "0.033 %", "1200 %", "-"])
        self.assertEqual([markdown.percent(x, 3) for x in (12.345, 0.99951, 0.99949, 0.001, None)],
                         ["1234 %", "100 %", "99.9 %", "0.1 %", "-"])

    def test_quantiles_are_edges_of_the_value_of_that_rank(self):
        hist = rows.Hist.parse(" ".join(f"{b}:1" for b in range(1, 101)))
        self.assertEqual(hist.quantile(0.5), rows.Hist.edge(50))
        self.assertEqual(hist.quantile(0.99), rows.Hist.edge(99))
        self.assertEqual(hist.quantile(1), rows.Hist.edge(100))
        self.assertEqual(rows.Hist.parse("1:1 2:1 3:1").quantile(0.5), rows.Hist.edge(2))
        self.assertIsNone(rows.Hist().quantile(0.5))

    def readme(self, table, shown, *options):
        self.write("README.md", f"Text\n<!-- begin report -->\n{shown}<!-- end -->\nmore\n")
        (self.folder / readme.PICTURE).parent.mkdir(parents=True, exist_ok=True)
        self.write(readme.PICTURE, "<svg/>")
        if table:
            self.write("readme.md", table)
        return self.call(readme.main, str(self.folder), "--report", str(self.folder), *options)[0]

    def test_readme_is_held_against_the_report_but_for_times(self):
        head = readme.from_report(pathlib.Path(self.write("readme.md", "")).parent)["report"]
        self.assertEqual(self.readme("| a | 3 | 12 × |\n", head + "| a | 3 | 9.5 × |\n"), 0)
        self.assertEqual(self.readme("| a | 3 | 12 × |\n", head + "| a | 4 | 12 × |\n"), 1)
        self.assertEqual(self.readme("| a | 3 | 12 × |\n", head + "| a | 4 | 12 × |\n", "--update"), 0)
        self.assertIn("| a | 3 | 12 × |\n<!-- end -->\nmore", (self.folder / "README.md").read_text())
        (self.folder / "readme.md").unlink()
        self.assertEqual(self.readme(None, head), 77)

    def test_report_says_what_is_not_there(self):
        code, said = self.call(lambda: render.draw_report(self.folder))
        report = (self.folder / "report.md").read_text()
        self.assertEqual(code, 0)
        self.assertIn("swept.csv not there", said)
        self.assertIn("*Not in this report: there is no swept.csv.*", report)

    def program(self, name, code):
        """A section that writes a file it may not be able to finish."""
        path = pathlib.Path(self.write(name, f"#!/bin/sh\necho ran > \"$2/{name}.ran\"\nexit {code}\n"))
        path.chmod(0o755)
        return str(path)

    def test_a_failed_section_fails_the_run_after_all_else(self):
        programs = [self.program("first", 1), self.program("second", 0)]
        code, said = self.call(run.main, str(self.folder), "quick", *programs)
        self.assertEqual(code, 1)
        self.assertIn("first ended with an error", said)
        self.assertNotIn("second ended", said)
        self.assertTrue((self.folder / "second.ran").is_file())
        self.assertTrue((self.folder / "report.md").is_file())
        self.assertEqual(self.call(run.main, str(self.folder), "quick", programs[1])[0], 0)


if __name__ == "__main__":
    unittest.main()
