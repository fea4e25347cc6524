#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants faults against the laws of motion, one at a time in a copy of the tree, and holds that the tests of the laws
notice each: a test that passes without the fault fails with it.

  python3 tests/mutation/planted.py --build build/host

Ends with 1 if a fault lives. Some minutes each: what is wrong is a header that all worlds are made of."""
import argparse
import pathlib
import re
import subprocess
import sys
from collections import namedtuple

from workbench import Bench

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = "batuta_test_random"
WORLD = "include/batuta/world/detail"
# text[before] -> after, once in the file; unit: the file of tests that has to notice it.
Fault = namedtuple("Fault", "name file before after unit")
FAULTS = [
    Fault("gravity at the start of the step", f"{WORLD}/bodies.hpp",
          "if (!state.loaded) v_W -= (rest / 2) * settings.gravity_W;", "", "tests/laws/random_blows_test.cpp"),
    Fault("momentum scaled in a hold", f"{WORLD}/weld.hpp",
          "  actor(heaviest).body.momentum.linear_W += left.linear_W;",
          "  actor(heaviest).body.momentum.linear_W += left.linear_W - sums.momentum_W / 1024;",
          "tests/laws/random_settling_test.cpp"),
    Fault("a weld without its spin", f"{WORLD}/weld.hpp",
          "sums.spin_W += body.momentum.angular_W + r_W.cross(own_W);", "sums.spin_W += r_W.cross(own_W);",
          "tests/laws/random_settling_test.cpp"),
    Fault("friction with the old normal impulse", "src/world/detail/lasting_contact.cpp",
          "if (contact.friction > Scalar(0)) relax_friction(point, A, B, contact.friction);",
          "point.normal -= change; if (contact.friction > Scalar(0)) relax_friction(point, A, B, contact.friction);"
          " point.normal += change;",
          "tests/laws/random_settling_test.cpp"),
]


def planted(text, fault):
    """The text with the fault. It is there once, or the list is out of date."""
    if text.count(fault.before) != 1:
        raise ValueError(f"{fault.name}: {fault.file} has {text.count(fault.before)} places for it")
    return text.replace(fault.before, fault.after)


def failures(executable):
    """Names of the tests that fail; "trap" where the program ends without saying."""
    done = subprocess.run([executable, "--gtest_brief=1"], capture_output=True, errors="replace", text=True,
                          check=False)
    found = set(re.findall(r"^\[  FAILED  \] ([^\s,]+)", done.stdout, re.M))
    return found if found or done.returncode == 0 else {"trap"}


def noticed(bench, fault, program, before):
    """Tests of the fault's unit that fail with the fault, and that did not fail before."""
    path = bench.tree / fault.file
    text = path.read_text()
    is_source = fault.file.startswith("src/")
    path.write_text(planted(text, fault))
    objects = {unit: bench.compile(unit, fault.file) for unit in ([fault.file] if is_source else [fault.unit])}
    executable = None if None in objects.values() else bench.link(program, objects, None if is_source else fault.unit)
    path.write_text(text)
    if executable is None:
        raise ValueError(f"{fault.name}: does not compile")
    return failures(executable) - before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = HERE.parent.parent
    parser.add_argument("--build", type=pathlib.Path, default=source / "build" / "host")
    parser.add_argument("--folder", type=pathlib.Path, default=source / "build" / "planted")
    given = parser.parse_args()
    bench = Bench(source, given.build.resolve(), given.folder.resolve())
    bench.set_up([PROGRAM], False)
    before = failures(bench.build / "tests" / PROGRAM)
    alive = 0
    for fault in FAULTS:
        killers = noticed(bench, fault, PROGRAM, before)
        alive += not killers
        print(f"{fault.name}: {', '.join(sorted(killers)) or 'LIVES'}", flush=True)
    return 1 if alive else 0


if __name__ == "__main__":
    sys.exit(main())
