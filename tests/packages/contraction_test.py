#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Nobody's flag forbids contraction, and the part can fuse: no file of the library has a fused instruction, whichever compiler made it. A
compiler that disregards what a file says (clang told -ffp-contract=fast) makes files that trap when the program starts, in every room.
Usage: contraction_test.py SOURCE_FOLDER EIGEN COMPILER... Exit code 77: skipped."""

import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, EIGEN = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
COMPILERS = [word for word in sys.argv[3:] if shutil.which(word)]
sys.path.insert(0, str(SOURCE / "toolchains/packages"))
import project as names  # noqa: E402

SKIPPED, TRAPPED = 77, 9
PROJECT = names.read_project(SOURCE)
FLAGS = ["-std=c++17", "-mfma", "-O1", "-fexpensive-optimizations", "-DBATUTA_WITH_DOUBLE=0", f"-I{SOURCE}/include", "-isystem", EIGEN]
FUSED = re.compile(r"\tvfn?m(?:add|sub)")
MAIN = """#include <cstdint>
#include <cstdlib>
extern "C" [[noreturn]] void batuta_trap(std::uint32_t, std::uint32_t) { std::_Exit(9); }
int main() {}
"""


def is_clang(compiler):
    return "clang" in subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode:
        raise AssertionError(f"{' '.join(words)}\n{done.stderr[-3000:]}")
    return done.stdout


def smallest_of(room):
    return min((SOURCE / "src" / room.name / source for source in room.sources), key=lambda path: path.stat().st_size)


def own_includes(path):
    """Files of the library that one names, in its order; those of C only declare."""
    for name in re.findall(r'(?m)^#include "([^"]+[.]hpp)"', path.read_text(encoding="utf-8")):
        found = [base / name for base in (SOURCE / "include", path.parent) if (base / name).exists()]
        yield from found[:1]


def first_read(path):
    """The file of the library whose own lines a compiler reads first: it goes down the first include of each."""
    below = next(own_includes(path), None)
    return path if below is None or path.name == "config.hpp" else first_read(below)


class Contraction(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="batuta-fused-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def compiled(self, compiler, source, *flags):
        made = self.folder / "made.o"
        run(compiler, *FLAGS, *flags, "-c", str(source), "-o", str(made))
        return made

    def fused_in(self, compiler, source, *flags):
        return len(FUSED.findall(run("objdump", "-d", str(self.compiled(compiler, source, *flags)))))

    def test_every_file_reads_first_what_forbids_it(self):
        others = [source for source in PROJECT.sources() if first_read(SOURCE / source).name != "config.hpp"]
        self.assertEqual(others, [])

    def test_no_room_is_fused(self):
        file = self.folder / "all.cpp"
        file.write_text("".join(f'#include "{SOURCE}/{source}"\n' for source in PROJECT.sources()), encoding="utf-8")
        for compiler in COMPILERS:
            with self.subTest(compiler):
                flags = [] if is_clang(compiler) else ["-ffp-contract=fast"]  # which is g++'s default
                self.assertEqual(self.fused_in(compiler, file, *flags), 0)

    def test_who_claims_a_flag_without_it_is_fused(self):
        file = SOURCE / "src/detection/advancement.cpp"  # shows that the test can see it
        for compiler in COMPILERS:
            with self.subTest(compiler):
                self.assertGreater(self.fused_in(compiler, file, "-ffp-contract=fast", "-DBATUTA_CONTRACTION_IS_OFF"), 10)

    def test_clang_that_disregards_files_traps_at_the_start(self):
        (self.folder / "main.cpp").write_text(MAIN, encoding="utf-8")
        for compiler in filter(is_clang, COMPILERS):
            run(compiler, "-c", str(self.folder / "main.cpp"), "-o", str(self.folder / "main.o"))
            for room in PROJECT.rooms:
                with self.subTest(room.name):
                    self.expect_trap(compiler, room, TRAPPED, "-ffp-contract=fast")
            self.expect_trap(compiler, PROJECT.rooms[0], 0)

    def expect_trap(self, compiler, room, code, *flags):
        made = self.compiled(compiler, smallest_of(room), *flags)
        program = self.folder / "program"
        run(compiler, str(self.folder / "main.o"), str(made), "-static", "-Wl,--unresolved-symbols=ignore-all", "-o", str(program))
        if " fma " in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"):
            self.assertEqual(subprocess.run([str(program)], check=False).returncode, code)
        else:
            print("LEFT OUT: this machine cannot fuse; that a file asks at the start is seen in its sections only")
            self.assertIn(".init_array", run("objdump", "-h", str(made)))


if __name__ == "__main__":
    if platform.machine() not in ("x86_64", "AMD64") or not shutil.which("objdump") or not COMPILERS:
        print("LEFT OUT: it takes an x86-64, objdump and a compiler")
        sys.exit(SKIPPED)
    print("compilers:", *COMPILERS)
    unittest.main(argv=sys.argv[:1])
