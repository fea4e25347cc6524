#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A page whose blocks do not work must not pass for one whose blocks do."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import follow_page

GOOD = """# A page
## First
```cpp
// file.txt
text
```
```sh
grep -q text file.txt
```
## Second
```sh
exit 3
```
"""


class FollowPage(unittest.TestCase):
    def follow(self, page, *headings):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "page.md").write_text(page, encoding="utf-8")
            (pathlib.Path(name) / "next.md").write_text("```sh\ngrep -q text file.txt\n```\n", encoding="utf-8")
            with mock.patch.object(sys, "argv", ["follow_page.py", name, "page.md", *headings]), \
                    contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as told:
                return follow_page.main(), told.getvalue()

    def test_blocks_are_written_and_run(self):
        self.assertEqual(self.follow(GOOD, "First")[0], 0)

    def test_a_block_that_fails_is_told_with_its_line(self):
        self.assertEqual(self.follow(GOOD), (1, "page.md:11: ended with 3\n"))

    def test_a_command_in_the_middle_that_fails_is_no_success(self):
        self.assertEqual(self.follow("```sh\nfalse\ntrue\n```\n")[0], 1)

    def test_a_file_that_a_block_needs_has_to_be_on_the_page(self):
        self.assertEqual(self.follow(GOOD.replace("// file.txt", "// another.txt"), "First")[0], 1)

    def test_a_section_that_is_not_there_is_a_fault(self):
        self.assertEqual(self.follow(GOOD, "Third")[0], 1)

    def test_a_page_goes_on_where_the_one_before_it_ended(self):
        self.assertEqual(self.follow(GOOD, "First", "next.md")[0], 0)
        self.assertEqual(self.follow("```sh\ntrue\n```\n", "next.md"), (1, "next.md:1: ended with 2\n"))  # no such file

    def test_a_page_without_commands_proves_nothing(self):
        self.assertEqual(self.follow("# A page\n")[0], 1)


if __name__ == "__main__":
    unittest.main()
