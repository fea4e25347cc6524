# SPDX-License-Identifier: MIT
"""The checks of check_source.py against small trees with planted faults."""

import pathlib
import tempfile
import unittest

import check_source

HEAD = "// SPDX-License-Identifier: MIT\n"


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def put(self, path, text):
        target = self.root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(HEAD + text)

    def assert_found(self, findings, *parts):
        self.assertEqual(len(findings), len(parts), findings)
        for finding, part in zip(findings, parts):
            self.assertIn(part, finding)


class Arrows(Tree):
    def check(self):
        return check_source.check_arrows(self.root)

    def test_upwards_is_allowed(self):
        self.put("include/batuta/world/w.hpp", '#include "batuta/core/a.hpp"\n#include "batuta/world/b.hpp"\n')
        self.put("src/world/w.cpp", '#include "batuta/world/w.hpp"\n#include <cmath>\n')
        self.put("port/platforms/host/h.cpp", '#include "batuta/world/w.hpp"\n#include "platforms/host/h.hpp"\n')
        self.assert_found(self.check())

    def test_downwards_is_found(self):
        self.put("include/batuta/core/a.hpp", '#include "batuta/world/w.hpp"\n')
        self.put("src/geometry/g.cpp", '\n  # include "batuta/mechanics/m.hpp"\n')
        self.put("src/mechanics/m.cpp", '#include <batuta/world/w.hpp>\n')
        self.assert_found(self.check(), "a.hpp:2: room core", "g.cpp:3: room geometry", "m.cpp:2: room mechanics")

    def test_port_and_relative_paths_are_found(self):
        self.put("src/core/a.cpp", '#include "platforms/host/trap.hpp"\n#include "../port/platforms/host/trap.hpp"\n#include "pool.hpp"\n')
        self.assert_found(self.check(), "host/trap.hpp", "../port", "pool.hpp")

    def test_private_header_of_the_room_is_allowed(self):
        self.put("src/core/a.cpp", '#include "helper.hpp"\n')
        self.put("src/core/helper.hpp", '#pragma once\n')
        self.assert_found(self.check())

    def test_unknown_room_is_found(self):
        self.put("include/batuta/attic/a.hpp", "")
        self.put("src/core/a.cpp", '#include "batuta/attic/a.hpp"\n')
        self.assert_found(self.check(), "attic is not a room", "no such room")

    def test_shared_parts_of_ports_read_no_port(self):
        self.put("port/platforms/host/h.cpp", '#include "shared/link/frame.hpp"\n#include "shared/firmware/bout.hpp"\n')
        self.put("port/shared/firmware/f.cpp", '#include "shared/link/frame.hpp"\n')
        self.assertEqual(self.check(), [])
        self.put("port/shared/link/l.cpp", '#include "shared/firmware/bout.hpp"\n#include "platforms/host/h.hpp"\n')
        self.assert_found(self.check(), "firmware/bout.hpp", "host/h.hpp")

    def test_port_of_another_port_is_found(self):
        self.put("port/platforms/host/h.cpp", '#include "platforms/mps2/m.hpp"\n#include "../src/core/a.hpp"\n')
        self.put("port/platforms/mps2/m.hpp", "")
        self.assert_found(self.check(), "port platforms/host", "port platforms/host")

    def test_only_the_page_reads_the_programs(self):
        self.put("port/programs/devices/d.hpp", "")
        self.put("port/platforms/web/b.cpp", '#include "programs/devices/d.hpp"\n#include "shared/link/frame.hpp"\n')
        self.assertEqual(self.check(), [])
        self.put("port/platforms/mps2/m.cpp", '#include "programs/devices/d.hpp"\n')
        self.put("port/platforms/web/c.cpp", '#include "platforms/mps2/m.hpp"\n')
        self.assert_found(self.check(), "port platforms/mps2", "port platforms/web")


class Words(Tree):
    def check(self):
        return check_source.check_words(self.root)

    def test_clean_code_has_no_findings(self):
        self.put("include/batuta/core/a.hpp", '#pragma once\n'
                 '#include <new>\n// A new idea: throw nothing, 0.5 of it.\n/* malloc\n 1.5 */\n'
                 'struct A { A(const A&) = delete; };\nconstexpr float kHalf = 0.5F;\n'
                 'static_assert(true, "a new 1.5");\nconst Scalar half = Scalar(0.5) * Scalar(-1e-3);\n'
                 'constexpr double kThird = 0.25;\nstd::array<double, 2> kTable = {0.5,\n  0.25};\nint big = 1\'000;\nfloat x = a1.x + v3.y;\n')
        self.assert_found(self.check())

    def test_forbidden_words_are_found(self):
        lines = ["auto* a = new int;", "delete a;", "void* b = malloc(3);", "std::vector<int> c;", "throw 1;",
                 "try {", "#include <iostream>", "printf(0);", "x = std::sin(x);", "Eigen::MatrixXf m;",
                 "dynamic_cast<A*>(b);", "#include <chrono>", "goto end;", "int _Frame;", "int a__b;"]
        self.put("src/core/a.cpp", "\n".join(lines) + "\n")
        findings = self.check()
        found_lines = {finding.split(":")[1] for finding in findings}
        self.assertEqual(found_lines, {str(i + 2) for i in range(len(lines))}, findings)

    def test_double_literals_are_found(self):
        self.put("src/core/a.cpp", "x = 0.5 * y;\nx = 1e-3;\nx = Scalar(2) * .5;\nx = 3.;\nx = Scalar(0.5) + 0.25;\n")
        self.assert_found(self.check(), ": 0.5", ": 1e-3", ": .5", ": 3.", ": 0.25")

    def test_deviation_is_passed_over(self):
        self.put("src/core/a.cpp", "::new (p) T(1);  // deviation: placement-new\n")
        self.assert_found(self.check())

    def test_condition_is_found_but_for_three_files(self):
        self.put("src/core/a.cpp", "#ifdef X\n#endif\n")
        self.put("include/batuta/core/config.hpp", "#pragma once\n#if 1\n#endif\n")
        self.assert_found(self.check(), "a.cpp:2: preprocessor condition")

    def test_eigen_is_included_in_one_place(self):
        self.put("src/core/a.cpp", '#include <Eigen/Core>\n#include <Eigenvalues>\n')
        self.put("include/batuta/core/detail/eigen.hpp", '#pragma once\n#include <Eigen/Core>\n')
        self.assert_found(self.check(), "a.cpp:2: includes Eigen past core/detail/eigen.hpp")

    def test_long_file_licence_and_guard_are_found(self):
        self.put("include/batuta/core/a.hpp", "#pragma once\n" + "\n" * 400)
        (self.root / "include/batuta/core/b.hpp").write_text("#ifndef B\n")
        self.assert_found(self.check(), "402 lines", "licence", "#pragma once", "preprocessor")


class Bounds(Tree):
    def check(self):
        return check_source.check_bounds(self.root)

    def test_bound_beside_above_or_in_the_docstring_is_fine(self):
        self.put("include/batuta/core/a.hpp", "#pragma once\n#include <array>\n"
                 "#define TRAP(x) \\\n  do { \\\n  } while (false)\n"
                 "namespace n {\nstruct A {\n  int x{};\n public:\n  /// Sums. Bound: N terms.\n"
                 "  template <class T>\n  T sum() const {\n    while (x > 0) --x;\n  }\n};\n"
                 "void f() {\n  for (;;) {  // Bound: 3\n  }\n  // Bound: 4\n  while (g()) {\n  }\n"
                 "  for_each(1);  // for (all)\n}\n}  // namespace n\n")
        self.assert_found(self.check())

    def test_loop_without_bound_is_found(self):
        self.put("src/core/a.cpp", "namespace n {\n/// Bound: 3\nvoid f() { for (;;) {} }\nvoid g() {\n  for (;;) {\n  }\n"
                 "  int i = 0;\n  while (i < 3) ++i;\n}\n}  // Bound: none\n")
        self.assert_found(self.check(), "a.cpp:6", "a.cpp:9")

    def test_bound_of_another_thing_does_not_count(self):
        self.put("src/core/a.cpp", "/// Bound: 3\nstruct A {\n  void f() {\n    for (;;) {\n    }\n  }\n};\n"
                 "/// Bound: 3\nint k = 0;\nvoid g() {\n  do {\n  } while (k > 0);\n}\n")
        self.assert_found(self.check(), "a.cpp:5", "a.cpp:13")


class Deviations(Tree):
    def check(self):
        return check_source.check_deviations(self.root)

    def test_same_sets_are_fine(self):
        self.put("tests/static/DEVIATIONS.md", "| `one` | why |\n")
        self.put("src/core/a.cpp", "x;  // NOLINT(check) deviation: one\n")
        self.assert_found(self.check())

    def test_difference_is_found_both_ways(self):
        self.put("tests/static/DEVIATIONS.md", "| `one` | why |\n")
        self.put("src/core/a.cpp", "x;  // deviation: two\n")
        self.assert_found(self.check(), "two is not in DEVIATIONS.md", "one is not in the code")

    def test_suppression_without_id_is_found(self):
        self.put("src/core/a.cpp", "x;  // NOLINT\n// cppcheck-suppress unusedFunction\n")
        self.assert_found(self.check(), "a.cpp:2", "a.cpp:3")



class Tags(Tree):
    def page(self, *rows):
        self.put("docs/test_cases.md", "\n".join(["| tag | what it is | where |", "| --- | --- | --- |", *rows, ""]))

    def check(self):
        return check_source.check_tags(self.root)

    def test_defined_and_used_is_good(self):
        self.put("tests/unit/a_test.cpp", 'TEST(A, Meets) {  // T01\n  run("T02, fast");\n}\n')
        self.page("| T01 | a thing | `a_test.cpp` |", "| T02 | another | `a_test.cpp` |")
        self.assert_found(self.check())

    def test_undefined_and_unused_are_found(self):
        self.put("tests/unit/a_test.cpp", "// T01, B07\n")
        self.page("| T01 | a thing | `a_test.cpp` |", "| R02 | another | `a_test.cpp` |")
        self.assert_found(self.check(), "B07 (a_test.cpp) is not defined", "R02 is in no test")

    def test_wrong_files_are_found(self):
        self.put("tests/unit/a_test.cpp", "// T01\n")
        self.put("tests/CMakeLists.txt", "# T01\n")
        self.page("| T01 | a thing | `a_test.cpp`, `b_test.cpp` |")
        self.assert_found(self.check(), "T01 is not in b_test.cpp", "T01 is also in CMakeLists.txt")

    def test_no_page_defines_nothing(self):
        self.put("tests/unit/a_test.cpp", "// T19b\n")
        self.assert_found(self.check(), "T19b (a_test.cpp) is not defined")


class Names(Tree):
    def check(self, **twice):
        return check_source.check_names(self.root, twice)

    def test_one_class_of_a_name_is_good(self):
        self.put("include/batuta/core/a.hpp", "class Walk;\nstruct Walk : Step<int> {};\nenum class Way { kOn };\n"
                 "template <class Step>\nstruct Walk<Step> {};\n"
                 "template <class Way, class T = std::void_t<>>\nstruct B {};\n")
        self.put("src/core/a.cpp", "// struct Walk {\nstd::string text = \"struct Walk {\";\n")
        self.assert_found(self.check())

    def test_a_second_one_is_found_wherever_it_is_nested(self):
        self.put("include/batuta/core/a.hpp", "class Pool {\n  struct Walk final {\n  };\n};\n")
        self.put("src/core/a.cpp", "namespace {\ntemplate <class S>\nclass [[nodiscard]] Walk\n"
                 "    : public Pool {\n};\n}\n")
        self.assert_found(self.check(), "a.hpp:3, src/core/a.cpp:4: class Walk is defined 2 times")

    def test_what_is_excused_is_needed(self):
        self.put("src/core/a.cpp", "struct Walk {};\nstruct B { struct Walk {}; };\n")
        self.assert_found(self.check(Walk=2))
        self.assert_found(self.check(Walk=3, Place=2), "Place is excused 2 times and defined 1 times",
                          "Walk is excused 3 times and defined 2 times")
        self.put("src/core/b.cpp", "union Walk {};\n")
        self.assert_found(self.check(Walk=2), "class Walk is defined 3 times")


if __name__ == "__main__":
    unittest.main()
