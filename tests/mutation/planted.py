#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants faults against the laws of motion, one at a time in a copy of the tree, and holds that the tests of the laws
notice each: a test that passes without the fault fails with it.

  python3 tests/mutation/planted.py --build build/host

Ends with 1 if a fault lives. A minute: what is compiled anew is three sources and one file of scenes."""
import argparse
import pathlib
import re
import subprocess
import sys
from collections import namedtuple

from workbench import Bench

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = "batuta_test_random"
MOTION = "src/world/detail/group_motion.cpp"
# before -> after, once in the file; tests: those that have to notice it; unit: the file of scenes that is compiled with
# a header that is at fault. Sources are compiled in seconds, and that unit in some more.
Fault = namedtuple("Fault", "name file before after tests unit", defaults=[None])
FAULTS = [
    Fault("gravity at the start of the step", "include/batuta/world/detail/course.hpp",
          "if (!state.loaded) v_W -= (rest / 2) * bodies.settings.gravity_W;", "", "Straight/*Flight*",
          "tests/laws/random_straight.cpp"),
    Fault("momentum scaled in a hold", MOTION, "  add(all.linear_W, Scalar(1), own.linear_W);",
          "  add(all.linear_W, Scalar(1) + Scalar(1) / 1024, own.linear_W);", "Lasting/*Momentum*"),
    Fault("a weld without its spin", MOTION, "  add(all.angular_W, Scalar(1), own.angular_W);", "", "Lasting/*Momentum*"),
    Fault("a weld that wins energy by its turn", MOTION,
          "    if (gained <= rounding && (is_kept || i >= kEnough)) return motion;", "    if (i > 0) return motion;",
          "Struck/*Energy*"),
    Fault("friction with the old normal impulse", "src/world/detail/contact_visit.cpp",
          "gain = relax_along(contact, point, A, B, gain);",
          "point.normal -= sides[k].change;\n"
          "gain = relax_along(contact, point, A, B, gain);\n"
          "point.normal += sides[k].change;", "Lasting/*Friction*"),
]


def planted(text, fault):
    """The text with the fault. It is there once, or the list is out of date."""
    if text.count(fault.before) != 1:
        raise ValueError(f"{fault.name}: {fault.file} has {text.count(fault.before)} places for it")
    return text.replace(fault.before, fault.after)


def failures(executable, tests):
    """Names of the tests that fail; "trap" where the program ends without saying."""
    done = subprocess.run([executable, "--gtest_brief=1", f"--gtest_filter={tests}"], capture_output=True,
                          errors="replace", text=True, check=False)
    found = set(re.findall(r"^\[  FAILED  \] ([^\s,]+)", done.stdout, re.M))
    return found if found or done.returncode == 0 else {"trap"}


def noticed(bench, fault):
    """Tests that fail with the fault and pass without."""
    path = bench.tree / fault.file
    text = path.read_text()
    path.write_text(planted(text, fault))
    unit = fault.unit or fault.file
    compiled = bench.compile(unit, fault.file)
    executable = compiled and bench.link(PROGRAM, {unit: compiled})
    path.write_text(text)
    if executable is None:
        raise ValueError(f"{fault.name}: does not compile")
    return failures(executable, fault.tests) - failures(bench.build / "tests" / PROGRAM, fault.tests)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = HERE.parent.parent
    parser.add_argument("--build", type=pathlib.Path, default=source / "build" / "host")
    parser.add_argument("--folder", type=pathlib.Path, default=source / "build" / "planted")
    given = parser.parse_args()
    bench = Bench(source, given.build.resolve(), given.folder.resolve())
    bench.set_up([PROGRAM], False)
    alive = 0
    for fault in FAULTS:
        killers = noticed(bench, fault)
        alive += not killers
        print(f"{fault.name}: {', '.join(sorted(killers)) or 'LIVES'}", flush=True)
    return 1 if alive else 0


if __name__ == "__main__":
    sys.exit(main())
