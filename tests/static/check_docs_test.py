# SPDX-License-Identifier: MIT
"""The checks of check_docs.py against small trees with planted faults."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import check_docs
import check_source_test

HERE = pathlib.Path(__file__).resolve().parent


class Tree(check_source_test.Tree):
    def put(self, path, text):
        target = self.root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)


class Links(Tree):
    def check(self):
        return check_docs.check_links(self.root)

    def test_files_and_headings_that_exist_are_right(self):
        self.put("docs/a.md", "# A: the `first` page, and *more*\n\n## Twice\n\n## Twice\n\n<a id=\"own\"></a>\n")
        self.put("src/world/note.md", "[up](../../docs/a.md) [here](#it)\n\n## It\n")
        self.put("README.md", "[a](docs/a.md#a-the-first-page-and-more) [b](docs/a.md#twice-1) [c](docs/a.md#own)\n"
                 "![p](docs/p.svg) [web](https://example.org/x#y) [src](src/world)\n[r]: docs/a.md\n")
        self.put("docs/p.svg", "")
        self.assert_found(self.check())

    def test_file_that_is_not_there_is_found_on_every_kind_of_page(self):
        for page in ("README.md", "docs/a.md", "src/world/note.md", "port/shared/link/link.md"):
            self.put(page, "\n[x](gone.md)\n")
        self.assert_found(self.check(), "README.md:2: gone.md leads to no file", "docs/a.md:2",
                          "src/world/note.md:2", "port/shared/link/link.md:2")

    def test_heading_that_is_not_there_is_found(self):
        self.put("docs/a.md", "# One\n\n```sh\n# two\n```\n")
        self.put("README.md", "[x](docs/a.md#two)\n[y](#three)\n")
        self.assert_found(self.check(), "README.md:1: docs/a.md#two leads to no heading",
                          "README.md:2: #three leads to no heading")

    def test_second_heading_of_a_name_is_only_there_if_it_is(self):
        self.put("README.md", "# One\n[x](#one-1)\n")
        self.assert_found(self.check(), "#one-1 leads to no heading")

    def test_link_over_two_lines_reference_and_title_are_seen(self):
        self.put("README.md", "[a\nb](gone.md)\n[c](gone2.md \"title\")\n\n[d]: gone3.md\n")
        self.assert_found(self.check(), "gone.md", "gone2.md", "README.md:5: gone3.md")

    def test_link_out_of_the_project_is_found(self):
        outside = pathlib.Path(tempfile.mkstemp(dir=self.root.parent)[1])
        self.addCleanup(outside.unlink)
        self.put("README.md", f"[x](../{outside.name})\n[y](/etc)\n")
        self.assert_found(self.check(), "leads out of the project", "is not relative")

    def test_code_is_no_link(self):
        self.put("README.md", "`[x](gone.md)` and\n\n```cpp\nauto f = [this](gone.md);\n```\n")
        self.assert_found(self.check())


class Paper(Tree):
    def setUp(self):
        super().setUp()
        self.put("src/world/a.cpp", "template <class S> S torque_of(S x);\nstruct Impulse { int magnitude; };\n")
        self.put("tests/unit/a_test.cpp", "TEST(Suite, Case_Holds) {}\nTYPED_TEST(Typed,\n           Case) {}\n"
                 "RC_GTEST_PROP(Any, Case, (int i)) {}\n")
        self.put("tests/static/CMakeLists.txt", "add_test(NAME static.arrows COMMAND x)\n")

    def check(self, text):
        self.put("docs/paper.md", text)
        return check_docs.check_paper(self.root)

    def test_what_exists_is_right(self):
        self.assert_found(self.check(
            "`src/world/a.cpp` `tests/unit` `torque_of()` `Impulse::magnitude` `torque_of<Impulse>`\n"
            "`Suite.Case_Holds` `Typed.Case` `Any.Case` `static.arrows` `cmake --workflow`\n\n"
            "```sh\n`gone.hpp`\n```\n"))

    def test_file_that_is_not_there_is_found(self):
        self.assert_found(self.check("\n`src/world/gone.cpp` `a.cpp`\n"),
                          "docs/paper.md:2: src/world/gone.cpp is no file", "a.cpp is no file")

    def test_test_that_is_not_there_is_found(self):
        self.assert_found(self.check("`Suite.Case` `Typed.Case_Holds` `static.gone`\n"),
                          "Suite.Case is no test", "Typed.Case_Holds is no test", "static.gone is no test")

    def test_name_that_the_code_does_not_have_is_found(self):
        self.assert_found(self.check("`torque()` `Impulse::gone`\n"), "torque() is no name", "Impulse::gone is no name")

    def test_own_text_of_the_check_is_no_code(self):
        self.put("tests/static/check_docs_test.py", "TEST(Planted, Here) planted_name\n")
        self.assert_found(self.check("`Planted.Here` `planted_name`\n"), "Planted.Here is no test",
                          "planted_name is no name")


class Program(Tree):
    def run_on(self, *folders):
        return subprocess.run([sys.executable, "-B", HERE / "check_docs.py", *folders], check=False,
                              capture_output=True, text=True)

    def test_ends_with_1_where_something_is_wrong(self):
        self.put("README.md", "[x](gone.md)\n")
        ended = self.run_on(self.root)
        self.assertEqual((ended.returncode, ended.stdout), (1, "README.md:1: gone.md leads to no file\n"))
        self.put("gone.md", "")
        self.assertEqual(self.run_on(self.root).returncode, 0)

    def test_wrong_usage_is_2(self):
        self.assertEqual(self.run_on().returncode, 2)


if __name__ == "__main__":
    unittest.main()
