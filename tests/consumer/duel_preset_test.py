#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the README asks of somebody who only wants to see a duel: no test library, few steps.
Usage: duel_preset_test.py SOURCE_FOLDER GROUP. Exit code 77: skipped."""

import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SOURCE, GROUP = pathlib.Path(sys.argv[1]), sys.argv[2]
SKIPPED = 77
MOST_STEPS = 80
NO_PART_OF_IT = re.compile(r"gtest|gmock|rapidcheck|benchmark|bullet|fcl|ode-|ccd|gnuplot|cppcheck|clang|gcovr|doxygen|python"
                           r"|xvfb|qemu|arm|aarch64|riscv")


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def run(*words, **more):
    result = subprocess.run(words, capture_output=True, text=True, check=False, timeout=3600, **more)
    check(result.returncode == 0, (words, result.stdout[-3000:], result.stderr[-3000:]))
    return result.stdout


def program(folder, name, text):
    path = folder / name
    path.write_text("#!/bin/sh\n" + text, encoding="ascii")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)


def installed_by(word):
    """What setup.sh installs on a machine that has nothing yet: a Debian whose package manager only takes notes."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program(folder, "id", "echo 0\n")
        program(folder, "dpkg-query", 'grep -qx -- "$4" %s/have 2>/dev/null && printf installed\n' % folder)
        program(folder, "apt-get", '[ "$1" = install ] || exit 0\nfor word; do printf "%%s\\n" "$word"; done >>%s/have\n' % folder)
        path = str(folder) + os.pathsep + os.environ["PATH"]
        run("sh", str(SOURCE / "toolchains/setup.sh"), word, env={**os.environ, "PATH": path})
        words = (folder / "have").read_text(encoding="ascii").split()
        return {word for word in words[1:] if not word.startswith("-")}  # without the command


def packages():
    duel, host = installed_by("duel"), installed_by("host")
    for name in "g++", "cmake", "ninja-build", "libeigen3-dev", "libsdl2-dev":
        check(name in duel, f"the list for the duel lacks {name}: {sorted(duel)}")
    check(duel < host, f"only in the list for the duel: {sorted(duel - host)}")
    foreign = sorted(filter(NO_PART_OF_IT.search, duel))
    check(not foreign, f"a duel does not need {foreign}")
    check(any(filter(NO_PART_OF_IT.search, host)), "the list for the host has test libraries")


def steps():
    """A tree of its own, so that nothing is there yet; a library of the tests that is looked for ends the configuration."""
    hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("GTest", "rapidcheck", "benchmark")]
    with tempfile.TemporaryDirectory() as tree:
        run("cmake", "--preset", "duel", "-B", tree, *hidden, cwd=SOURCE)
        cache = (pathlib.Path(tree) / "CMakeCache.txt").read_text(encoding="utf-8")
        for name in "gtest", "rapidcheck", "bullet", "fcl", "libode", "libccd":
            check(not re.search(rf"^(?!CMAKE_DISABLE_)\w*{name}\w*:", cache, re.I | re.M), f"{name} was looked for")
        plan = [line for line in run("ninja", "-C", tree, "-n", "run-duel").splitlines() if line.startswith("[")]
    print(len(plan), "steps")
    check(10 < len(plan) <= MOST_STEPS, f"{len(plan)} steps, bound {MOST_STEPS}")


def owners(files):
    """The packages that files belong to; with links followed, since /usr/lib may be reached by two names."""
    listing = run("dpkg", "-S", *sorted({os.path.realpath(file) for file in files}))
    return {name.strip().split(":")[0] for line in listing.splitlines() for name in line.split(": ")[0].split(",")}


def with_dependencies(names):
    """Packages that are installed with these, recommendations left out as setup.sh does."""
    fields = {}
    form = "${Package}\t${Pre-Depends}, ${Depends}\t${Provides}\n"
    for line in run("dpkg-query", "-W", "-f", form).splitlines():
        package, depends, provides = line.split("\t")
        for name in [package, *re.findall(r"[a-z0-9][a-z0-9+.-]+(?=[ ,]|$)", provides)]:
            fields.setdefault(name, []).append((package, depends))
    found, open_names = set(), list(names)
    while open_names:
        for package, depends in fields.get(open_names.pop(), []):
            if package not in found:
                found.add(package)
                open_names += re.findall(r"(?:^|[,|]\s*)([a-z0-9][a-z0-9+.-]+)", depends)
    return found


def workflow():
    """As the README says it; then every header that was read comes from the packages that `setup.sh duel` installs."""
    run("cmake", "--workflow", "--preset", "duel", cwd=SOURCE)
    tree = SOURCE / "build/duel"
    picture = xml.etree.ElementTree.parse(tree / "duel.svg").getroot()
    check(picture.tag.endswith("}svg"), picture.tag)
    if not os.path.exists("/usr/bin/dpkg"):
        return
    read = set(re.findall(r"^    (/usr/.*)$", run("ninja", "-C", str(tree), "-t", "deps"), re.M))
    check(len(read) > 100, read)
    missing = owners(read) - with_dependencies(installed_by("duel"))
    check(not missing, f"setup.sh duel does not install {missing}")


GROUPS = {"Packages": packages, "Steps": steps, "Workflow": workflow}
GROUPS[GROUP]()
