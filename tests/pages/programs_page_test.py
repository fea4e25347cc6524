#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every line of docs/programs.md and compares its options with what each program says of itself.

programs_page_test.py PAGE BUILD_FOLDER EVENTS: the folder that holds the programs, and a recording of a stick
"""

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile

PROGRAMS = ("batuta-duel", "batuta-mass", "batuta-answer", "batuta-feel")
TIMEOUT_S = 120
# Each line of the page: its exit code, and what it must say. A line that is not here fails, and so does one that the page has lost.
# Without a board or a display the programs must say what they miss.
EXPECTED = {
    "build/host/batuta-duel --left serial:/dev/ttyACM0 --right script:parry": (2, "/dev/ttyACM0"),
    "build/host/batuta-duel --left serial:/dev/ttyACM0@1000000,stick.events": (2, "/dev/ttyACM0"),
    "build/host/batuta-duel --view": (2, "display"),
    "build/host/batuta-duel --figure docs/hardest_beat.svg": (0, "touch"),
    "build/host/batuta-duel --touches 1 --left script:attack --right script:guard --strip docs/touch_strip.svg": (0, "touch"),
    "build/host/batuta-mass epee.stl --scale 0.001 --mass 0.77": (0, "make_compound"),
    "printf 'A0x,A0y,A0z,A1x,A1y,A1z,B0x,B0y,B0z,B1x,B1y,B1z\\n0.0,0.0,0.0,1.0,0.0,0.0,0.0,2.0,-1.0,0.0,2.0,1.0\\n' |"
    " build/host/batuta-answer distance --in - --out -": (0, "1,2,0,0.5,0,1,0"),
    "build/host/batuta-feel 100": (0, "clipped"),
    "build/host/batuta-feel --measure": (0, "it bears"),
}
# What other tests run: each with the one that does.
ELSEWHERE = {
    "sh toolchains/setup.sh duel": "consumer.Duel_Packages",
    "cmake --workflow --preset duel": "consumer.Duel_Workflow",
}
WRITTEN = ("docs/hardest_beat.svg", "docs/touch_strip.svg")


def check(condition, what):
    if not condition:
        sys.exit("FAILED: %s" % (what,))


def lines_of(page):
    """The commands of the page: lines of its blocks of shell, and programs called in running text."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    lines = [line.split("  #")[0].strip() for block in blocks for line in block.splitlines()]
    inline = re.findall(r"`(build/host/[^`]* [^`]*)`", page)
    return [line for line in lines + inline if line]


def sections(page):
    """What the page says of each program."""
    parts = re.split(r"^## (batuta-\w+)", page, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def box_in_mm():
    """A blade of 10 x 10 x 1000 mm as a binary STL."""
    corners = [(x, y, z) for x in (0, 10) for y in (0, 10) for z in (0, 1000)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in (1, 2)]
    numbers = [[x for corner in triangle for x in corners[corner]] for triangle in triangles]
    return b"".ljust(80) + struct.pack("<I", len(numbers)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *corners_of, 0) for corners_of in numbers)


def furnish(folder, build, events):
    """What the page's lines expect around them."""
    os.makedirs(os.path.join(folder, "build"))
    os.makedirs(os.path.join(folder, "docs"))
    os.symlink(build, os.path.join(folder, "build/host"))
    for ending in (".events", ".desc"):
        source = os.path.splitext(events)[0] + ending
        if os.path.exists(source):
            shutil.copyfile(source, os.path.join(folder, "stick" + ending))
    with open(os.path.join(folder, "epee.stl"), "wb") as file:
        file.write(box_in_mm())


def run_line(line, folder):
    code, words = EXPECTED[line]
    surroundings = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    done = subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=folder, env=surroundings, capture_output=True,
                          text=True, timeout=TIMEOUT_S, check=False)
    said = done.stdout + done.stderr
    check(done.returncode == code, (line, "exit code", done.returncode, said[-2000:]))
    check(words in said, (line, "does not say", words, said[-2000:]))


def options_of(text):
    """Long options but for those that every program has."""
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)) - {"--help", "--version"}


def help_of(program, build):
    """What a program and its subcommands say of themselves."""
    texts = []
    for words in ([], ["toc"], ["distance"], ["impulse"]) if program == "batuta-answer" else ([],):
        done = subprocess.run([os.path.join(build, program), *words, "--help"], capture_output=True, text=True,
                              timeout=TIMEOUT_S, check=False)
        check(done.returncode == 0, (program, words, "--help", done.returncode, done.stderr))
        texts.append(done.stdout)
    return "\n".join(texts)


def compare_options(program, section, build):
    usage = "".join(re.findall(r"^    (?=\S).*$|^     +\[.*$", section, re.MULTILINE))
    check(program in usage, (program, "has no line of usage on the page"))
    known = options_of(help_of(program, build))
    told = options_of(section)
    check(known <= told, (program, "the page does not tell", sorted(known - told)))
    check(options_of(usage) <= known, (program, "has no", sorted(options_of(usage) - known)))
    if program != "batuta-answer":  # whose subcommands differ
        check(known <= options_of(usage), (program, "its usage on the page lacks", sorted(known - options_of(usage))))


def main():
    page_file, build, events = sys.argv[1:4]
    with open(page_file, encoding="utf-8") as file:
        page = file.read()
    lines = lines_of(page)
    named = set(lines) - set(ELSEWHERE)
    check(named == set(EXPECTED), ("lines without an expectation, or the reverse", sorted(named ^ set(EXPECTED))))
    told = sections(page)
    check(set(told) == set(PROGRAMS), ("programs with a section", sorted(told)))
    for program, section in told.items():
        compare_options(program, section, build)
    with tempfile.TemporaryDirectory() as folder:
        furnish(folder, os.path.abspath(build), events)
        for line in sorted(EXPECTED):
            run_line(line, folder)
        for name in WRITTEN:
            check(os.path.getsize(os.path.join(folder, name)) > 0, (name, "is empty"))
    print("%d lines of the page run" % len(EXPECTED))


if __name__ == "__main__":
    main()
