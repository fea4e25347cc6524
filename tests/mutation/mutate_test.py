# SPDX-License-Identifier: MIT
"""What is planted, and what is not; what becomes of it is tried on a small library of its own."""
import collections
import json
import pathlib
import subprocess
import tempfile
import unittest

import mutate
import mutations
import planted as laws_faults


def planted(text):
    """{(kind, before, after)} of a text"""
    return {(m.kind, m.before, m.after) for m in mutations.mutations_of("a.cpp", text)}


def changed(text):
    return [mutations.apply(text, m) for m in mutations.mutations_of("a.cpp", text)]


class Operators(unittest.TestCase):
    def test_arithmetic(self):
        self.assertEqual(planted("return a + b * c - d / e;"),
                         {("operator", *pair) for pair in (("+", "-"), ("*", "/"), ("-", "+"), ("/", "*"))})

    def test_comparison_has_its_boundary_and_its_opposite(self):
        self.assertEqual(changed("return a < b;"), ["return a <= b;", "return a >= b;"])
        self.assertEqual(changed("return a == b;"), ["return a != b;"])

    def test_logic_and_bits(self):
        self.assertEqual(planted("x = a && b || (c << d);") & {("operator", "&&", "||"), ("operator", "||", "&&")},
                         {("operator", "&&", "||"), ("operator", "||", "&&")})
        self.assertIn(("operator", "<<", ">>"), planted("x = a << b;"))

    def test_signs(self):
        self.assertEqual(changed("return -a;"), ["return a;"])
        self.assertEqual(changed("return f(a, -b);"), ["return f(a, b);"])

    def test_pointers_references_and_templates_are_none(self):
        for text in ("const T* f(T& a, T&& b, X<Y<T>> c, T* const* d);", "template <class T, int N>", "x->y;", "*a;",
                     "bool operator<(const T& a, const T& b);", "for (const T& a : all)"):
            self.assertEqual(planted(text), set(), text)


class Constants(unittest.TestCase):
    def test_whole_real_and_true(self):
        self.assertEqual(changed("return 7;"), ["return 8;"])
        self.assertEqual(changed("return 0x1FU;"), ["return 0x20U;"])
        self.assertEqual(changed("return 0.25F;"), ["return 0.5F;"])
        self.assertEqual(changed("return 0.0;"), ["return 1.0;"])
        self.assertEqual(changed("return true;"), ["return false;"])

    def test_names_and_arguments_of_templates_are_none(self):
        for text in ("return a1;", "return R2D2<3>;", "std::array<Scalar, 3> a;"):
            self.assertEqual(planted(text), set(), text)


class Branches(unittest.TestCase):
    def test_condition_is_negated(self):
        self.assertEqual(changed("if (good) return;"), ["if (!(good)) return;"])
        self.assertEqual(changed("if (auto x = f(); x) return;"), ["if (auto x = f(); !(x)) return;"])

    def test_one_comparison_has_its_opposite_already(self):
        self.assertNotIn("branch", {kind for kind, _, _ in planted("if (a < b) return;")})

    def test_not_is_dropped(self):
        self.assertIn("if (good) return;", changed("if (!good) return;"))

    def test_extremes_are_swapped(self):
        self.assertEqual(changed("return max_of(a, b);"), ["return min_of(a, b);"])
        self.assertEqual(changed("return a.minCoeff();"), ["return a.maxCoeff();"])


class Statements(unittest.TestCase):
    def test_assignments_calls_steps_and_jumps(self):
        self.assertEqual(changed("{\n  a.b[i] = c;\n  clear(d);\n}\n"),
                         ["{\n  ;\n  clear(d);\n}\n", "{\n  a.b[i] = c;\n  ;\n}\n"])
        self.assertEqual(changed("if (a) break;\n"), ["if (!(a)) break;\n", "if (a) ;\n"])

    def test_declarations_and_returns_stay(self):
        self.assertEqual(planted("{\n  const Scalar a = b;\n  Vec3 c;\n  return d;\n}\n"), set())


class Unread(unittest.TestCase):
    def test_comments_strings_and_what_only_the_compiler_reads(self):
        for text in ("// a + b\n", "/* if (a) */\n", 'x("a + b 1");', "#define A (1 + \\\n 2)\n",
                     "static_assert(a < 3);", "[[maybe_unused]]", "using A = B<1 + 2>;", "virtual void f() = 0;",
                     "enum class E { kA = 0, kB = 1 };", "BATUTA_ASSERT(a < b && c(1));"):
            self.assertEqual(planted(text), set(), text)

    def test_places_are_kept(self):
        text = '/* one\n two */ auto x = "+";\nreturn a + b;  // + c\n'
        found, = mutations.mutations_of("a.cpp", text)
        self.assertEqual((found.line, mutations.apply(text, found)), (3, text.replace("a + b", "a - b")))


class Names(unittest.TestCase):
    def test_do_not_move_with_the_line(self):
        names = [mutations.name_of(text, mutations.mutations_of("a.cpp", text)[0])
                 for text in ("  return a + b;\n", "\n\n      return a + b;\n")]
        self.assertEqual(names, ["a.cpp: return a + b; @9: + -> -"] * 2)

    def test_accepted_survivors_are_there(self):
        root = mutate.HERE.parent.parent
        there = mutate.all_mutations(root, list(mutate.STRONGER))
        for start in mutate.reasons(mutate.HERE / "survivors.json"):
            self.assertTrue(any(name.startswith(start) for name in there), f"no such mutation any more: {start}")


class Sample(unittest.TestCase):
    found = {f"{file}: {i}": mutations.Mutation(file, 1, "operator", 0, 0, "a", "b")
             for file, count in (("src/core/a.cpp", 90), ("include/batuta/core/a.hpp", 10), ("src/port/b.cpp", 3),
                                 ("include/batuta/world/c.hpp", 50)) for i in range(count)}

    def drawn(self, count, seed=1):
        names = mutate.sample(self.found, mutate.options(["--count", str(count), "--seed", str(seed)]))
        self.assertEqual(len(set(names)), len(names))
        return collections.Counter(mutate.room_of(self.found[name].file) for name in names)

    def test_each_room_has_as_many_or_all_it_has(self):
        self.assertEqual(self.drawn(9), {"core": 3, "port": 3, "world": 3})
        self.assertEqual(self.drawn(60), {"core": 20, "port": 3, "world": 20})
        self.assertEqual(self.drawn(0), {"core": 100, "port": 3, "world": 50})

    def test_a_part_of_it_is_even(self):
        names = mutate.sample(self.found, mutate.options(["--count", "60"]))[:12]
        rooms = collections.Counter(mutate.room_of(self.found[name].file) for name in names)
        self.assertLessEqual(max(rooms.values()) - min(rooms.values()), 2)

    def test_seed_decides(self):
        draw = [mutate.sample(self.found, mutate.options(["--count", "30", "--seed", seed])) for seed in "112"]
        self.assertEqual(draw[0], draw[1])
        self.assertNotEqual(draw[0], draw[2])

    def test_every_room_of_the_library_is_there(self):
        root = mutate.HERE.parent.parent
        folders = {path.name for base in ("src", "include/batuta") for path in (root / base).iterdir() if path.is_dir()}
        self.assertEqual(set(mutate.STRONGER), folders)


class Report(unittest.TestCase):
    results = {"src/core/a.cpp: x": ["killed", "T"], "src/core/a.cpp: y": ["alive", ""],
               "include/batuta/port/b.hpp: z": ["killed by stronger tests", "T"],
               "src/port/c.cpp: w": ["does not compile", ""]}

    def test_shares(self):
        table = mutate.tallies(self.results)
        self.assertEqual([mutate.share(table[room]) for room in ("core", "port")], [50.0, 100.0])
        self.assertAlmostEqual(mutate.share(table["all"]), 200 / 3)
        self.assertEqual(mutate.least_share(self.results), 50.0)
        self.assertEqual(mutate.least_share({}), 100.0)

    def test_survivors_have_their_reason(self):
        known = {"src/core/a.cpp: y": "the same answer"}
        self.assertIn("  the same answer", "\n".join(mutate.report(self.results, known)))
        self.assertIn("NO REASON", "\n".join(mutate.report(self.results, {})))


LIBRARY = """#include "batuta/core/sign.hpp"
int sign(int x) {
  if (x < kNone) return -1;
  while (x > 9) x = x / 10;
  return x > 0 ? 1 : 0;
}
"""
TEST = """#include "batuta/core/sign.hpp"
int main() { return sign(-5) == -1 && sign(0) == 0 && sign(70) == 1 ? 0 : 1; }
"""
NINJA = """rule cc
  command = c++ -I{0}/include -o $out -c $in
rule cc_prepared
  command = c++ -I{0}/include -include {0}/build/cmake_pch.hxx -o $out -c $in
rule ar
  command = ar rcs $out $in
rule ld
  command = : && c++ $in -o $out && :
build sign.cpp.o: cc {0}/src/core/sign.cpp
build tests/sign_test.cpp.o: cc_prepared {0}/tests/sign_test.cpp
build libcore.a: ar sign.cpp.o
build tests/batuta_test_core: ld tests/sign_test.cpp.o libcore.a
build batuta_test_core: phony tests/batuta_test_core
"""


# Of two tests one reads the header and asks for nothing in it; the other one asks the library, and reads no header.
TESTS_OF_TWO = {
    "tests/main.cpp": "int wrong = 0;\nint main() { return wrong; }\n",
    "tests/reader_test.cpp": '#include "batuta/core/sign.hpp"\nint of_reader = kNone;\n',
    "tests/other_test.cpp": "int sign(int x);\nextern int wrong;\nint of_other = wrong += sign(0) == 0 ? 0 : 1;\n",
}
NINJA_OF_TWO = NINJA.split("build sign.cpp.o")[0] + """build sign.cpp.o: cc {0}/src/core/sign.cpp
build libcore.a: ar sign.cpp.o
build tests/batuta_test_core.dir/main.cpp.o: cc {0}/tests/main.cpp
build tests/batuta_test_core.dir/reader_test.cpp.o: cc {0}/tests/reader_test.cpp
build tests/batuta_test_core.dir/other_test.cpp.o: cc {0}/tests/other_test.cpp
build tests/batuta_test_core: ld tests/batuta_test_core.dir/main.cpp.o tests/batuta_test_core.dir/reader_test.cpp.o $
  tests/batuta_test_core.dir/other_test.cpp.o libcore.a
build batuta_test_core: phony tests/batuta_test_core
"""


class Trials(unittest.TestCase):
    """On a library of one function, whose build ninja made."""

    def setUp(self):
        self.make({"tests/sign_test.cpp": TEST}, NINJA)

    def make(self, tests, ninja):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        self.write("src/core/sign.cpp", LIBRARY)
        self.write("include/batuta/core/sign.hpp", "#pragma once\nconstexpr int kNone = 0;\nint sign(int x);\n")
        for name, text in tests.items():
            self.write(name, text)
        self.write("port/none.hpp", "")
        self.write("build/build.ninja", ninja.format(self.root))
        self.write("build/cmake_pch.hxx", f'#include "{self.root}/include/batuta/core/sign.hpp"\n')
        database = subprocess.run(["ninja", "-C", self.root / "build", "-t", "compdb", "cc", "cc_prepared"],
                                  capture_output=True, text=True, check=True).stdout
        self.write("build/compile_commands.json", database)
        subprocess.run(["ninja", "-C", self.root / "build"], stdout=subprocess.DEVNULL, check=True)
        self.bench = mutate.Bench(self.root, self.root / "build", self.root / "mutation")
        self.bench.set_up(["batuta_test_core"], keep=False)
        self.bench.patience_with = lambda program: 1
        self.found = mutate.all_mutations(self.root, ["core"])
        self.addCleanup(mutate.STRONGER.update, core=mutate.STRONGER["core"])
        mutate.STRONGER["core"] = []

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def verdict(self, name):
        return mutate.Trial(self.bench, self.found[name]).verdict()

    def test_killed_alive_and_hanging(self):
        source = "src/core/sign.cpp: "
        self.assertEqual(self.verdict(source + "if (x < kNone) return -1; @6: < -> >=")[0], mutate.KILLED)
        self.assertEqual(self.verdict(source + "while (x > 9) x = x / 10; @9: > -> >=")[0], mutate.ALIVE)
        self.assertEqual(self.verdict(source + "while (x > 9) x = x / 10; @9: > -> <="), (mutate.KILLED, "hangs"))

    def test_first_to_meet_a_program_meets_it_mutated(self):
        del self.bench.patience_with  # which times the program as it is
        self.assertEqual(self.verdict("src/core/sign.cpp: if (x < kNone) return -1; @6: < -> >=")[0], mutate.KILLED)

    def test_header_is_followed_to_its_readers(self):
        name = "include/batuta/core/sign.hpp: constexpr int kNone = 0; @22: 0 -> 1"
        self.assertEqual(self.verdict(name)[0], mutate.KILLED)
        self.assertEqual((self.bench.tree / "include/batuta/core/sign.hpp").read_text(),
                         (self.root / "include/batuta/core/sign.hpp").read_text())

    def test_header_meets_the_tests_that_do_not_read_it_too(self):
        self.make(TESTS_OF_TWO, NINJA_OF_TWO)
        name = "include/batuta/core/sign.hpp: constexpr int kNone = 0; @22: 0 -> 1"
        self.assertEqual(self.verdict(name)[0], mutate.KILLED)

    def test_what_the_build_prepares_does_not_stand_beside_a_mutated_header(self):
        header = "include/batuta/core/sign.hpp"
        self.write(f"mutation/tree/{header}", (self.root / header).read_text().replace("0", "1"))
        self.assertIsNotNone(self.bench.compile("tests/sign_test.cpp", header))

    def test_build_is_brought_up_to_date_or_nothing_is_tried(self):
        self.write("src/core/sign.cpp", LIBRARY.replace("return -1", "return -2"))
        self.bench.set_up(["batuta_test_core"], keep=False)
        with self.assertRaises(mutate.NotReady):
            self.bench.time_of("batuta_test_core")
        self.write("src/core/sign.cpp", "no code")
        with self.assertRaises(mutate.NotReady):
            self.bench.set_up(["batuta_test_core"], keep=False)

    def test_build_of_another_tree_is_refused(self):
        elsewhere = mutate.Bench(self.root / "mutation" / "tree", self.root / "build", self.root / "other")
        with self.assertRaises(mutate.NotReady):
            elsewhere.set_up(["batuta_test_core"], keep=True)

    def test_results_are_kept_of_what_is_there(self):
        path = self.root / "results.json"
        mutate.Book(path, False, {}).add("a", ("killed", "T"))
        self.assertEqual(json.loads(path.read_text()), {"a": ["killed", "T"]})
        self.assertEqual(mutate.Book(path, False, {"a", "b"}).results, {"a": ["killed", "T"]})
        self.assertEqual(mutate.Book(path, False, {"b"}).results, {})
        self.assertEqual(mutate.Book(path, True, {"a"}).results, {})


class PlantedFaults(unittest.TestCase):
    def test_each_has_one_place(self):
        source = pathlib.Path(__file__).resolve().parent.parent.parent
        for fault in laws_faults.FAULTS:
            text = (source / fault.file).read_text()
            self.assertNotEqual(laws_faults.planted(text, fault), text, fault.name)
            self.assertTrue((source / (fault.unit or fault.file)).is_file(), fault.name)
            self.assertRaises(ValueError, laws_faults.planted, "", fault)


if __name__ == "__main__":
    unittest.main()
