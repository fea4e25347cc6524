#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of merging and drawing that need no section's program."""

import contextlib
import io
import pathlib
import sys
import tempfile
import types
import unittest
from unittest import mock

import fit
import markdown
import merge
import plot
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

    def test_slope_is_the_order_of_a_power(self):
        self.assertAlmostEqual(fit.slope([(x, 3 * x ** 2) for x in (0.1, 1, 7)]), 2)
        self.assertAlmostEqual(fit.slope([(1, 5), (2, 2.5), (3, 0)]), -1)  # a zero is no point of it
        self.assertIsNone(fit.slope([(1, 5)]))

    def test_quantiles_are_edges_of_the_value_of_that_rank(self):
        hist = rows.Hist.parse(" ".join(f"{b}:1" for b in range(1, 101)))
        self.assertEqual(hist.quantile(0.5), rows.Hist.edge(50))
        self.assertEqual(hist.quantile(0.99), rows.Hist.edge(99))
        self.assertEqual(hist.quantile(1), rows.Hist.edge(100))
        self.assertEqual(rows.Hist.parse("1:1 2:1 3:1").quantile(0.5), rows.Hist.edge(2))
        self.assertIsNone(rows.Hist().quantile(0.5))

    def blocks(self, **texts):
        (self.folder / "blocks").mkdir(exist_ok=True)
        for mark, text in texts.items():
            self.write(f"blocks/{mark}.md", text)

    def page(self, name, **shown):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("Text\n" + "".join(f"<!-- begin {mark} -->\n{text}<!-- end -->\nmore\n" for mark, text in shown.items()))
        return path

    def readme(self, *options, blocks=("README.md:report",)):
        return self.call(readme.main, str(self.folder), "--report", str(self.folder), *blocks, *options)

    def test_readme_is_held_against_the_report_but_for_times(self):
        self.blocks(report="| a | 3 | 12 × |\n")
        self.page("README.md", report="| a | 3 | 9.5 × |\n")
        self.assertEqual(self.readme()[0], 0)
        page = self.page("README.md", report="| a | 4 | 12 × |\n")
        code, said = self.readme()
        self.assertEqual(code, 1)
        self.assertIn("README.md is not what the code says", said)
        self.assertEqual(self.readme("--update")[0], 0)
        self.assertEqual(page.read_text(), "Text\n<!-- begin report -->\n| a | 3 | 12 × |\n<!-- end -->\nmore\n")
        (self.folder / "blocks" / "report.md").unlink()
        self.assertEqual(self.readme()[0], 77)

    def test_blocks_go_where_they_are_asked_with_their_pictures(self):
        self.blocks(report="![One](one.svg)\n1\n", beat="![Two](two.svg)\n2\n")
        for name in ("one.svg", "two.svg"):
            self.write(name, f"<svg>{name}</svg>")
        front, inner = self.page("README.md", report=""), self.page("docs/error.md", beat="old\n", report="")
        pictures = self.folder / readme.PICTURES
        pictures.mkdir(parents=True)
        wanted = ("README.md:report", "docs/error.md:report", "docs/error.md:beat")
        self.assertEqual(self.readme("--update", blocks=wanted)[0], 0)
        self.assertIn("begin report -->\n![One](tests/measure/report/one.svg)\n1\n<!-- end", front.read_text())
        self.assertIn("begin report -->\n![One](../tests/measure/report/one.svg)\n1\n<!-- end", inner.read_text())
        self.assertIn("begin beat -->\n![Two](../tests/measure/report/two.svg)\n2\n<!-- end", inner.read_text())
        self.assertEqual((pictures / "two.svg").read_text(), "<svg>two.svg</svg>")
        self.assertEqual(self.readme(blocks=wanted)[0], 0)
        (pictures / "two.svg").unlink()
        self.assertEqual(self.readme(blocks=wanted)[0], 1)
        self.assertEqual(self.readme(blocks=wanted[:2])[0], 0)
        with self.assertRaisesRegex(SystemExit, "docs/error.md: .*flight.* occurs 0 times"):
            self.blocks(flight="3\n")
            self.readme(blocks=("docs/error.md:flight",))

    def test_times_of_a_busy_host_are_written_nowhere(self):
        self.blocks(report="| a | 3 | 12 × |\n")
        page = self.page("README.md", report="| a | 3 | 9.5 × |\n")
        before = page.read_text()
        self.write(render.BUSY, "search: the host was busy\n")
        code, said = self.readme("--update")
        self.assertEqual(code, 1)
        self.assertIn("search: the host was busy\nnothing is written", said)
        self.assertEqual(page.read_text(), before)
        self.assertEqual(self.readme()[0], 0)  # what is no time may be compared

    def timed_section(self, disturbed):
        """Draws a report whose only section has this many disturbed baselines."""
        rows_of = "name,time_ns:max,time_baselines:sum,time_disturbed:sum\n" + f"a,1,3,{disturbed}\nb,1,2,0\n"
        self.write("timed.csv", rows_of)
        module = types.SimpleNamespace(TITLE="Timed", FILES=["timed"], page=lambda tables, folder: "page\n",
                                       blocks=lambda tables: {"report": "block\n"})
        with mock.patch.object(render, "SECTIONS", ["timed"]), mock.patch.dict(sys.modules, {"pages.timed": module}):
            code, said = self.call(lambda: render.draw_report(self.folder))
        self.assertEqual(code, 0)
        return said, (self.folder / "report.md").read_text()

    def test_report_says_that_the_host_was_busy(self):
        said, report = self.timed_section(2)
        self.assertIn("2 of 5 baselines were interrupted", said)
        self.assertIn("2 of 5 baselines were interrupted", report)
        self.assertIn("2 of 5 baselines", (self.folder / render.BUSY).read_text())
        self.assertEqual((self.folder / "blocks" / "report.md").read_text(), "block\n")
        said, report = self.timed_section(0)
        self.assertEqual(said, "")
        self.assertNotIn("busy", report)
        self.assertFalse((self.folder / render.BUSY).is_file())

    def labels(self, x, logs="xy"):
        panel = plot.Panel("", "", "", [plot.Series("", [(value, value) for value in x], 0)], logs=logs)
        return [line for line in panel.lines(0) if line.startswith(("set format x", "set xtics"))]

    def test_labels_of_a_long_axis_are_short_and_few(self):
        self.assertEqual(self.labels([1, 1000]), ["set format x '%g'", "set xtics autofreq"])
        self.assertEqual(self.labels([1e-9, 1e9]), ["set format x '10^{%L}'", "set xtics 1000"])
        self.assertEqual(self.labels([1e-6, 1e-2]), ["set format x '10^{%L}'", "set xtics autofreq"])
        self.assertEqual(self.labels([0, 1e9], logs="y"), ["set format x '%g'", "set xtics autofreq"])

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
