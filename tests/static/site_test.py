#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants faults in a copy of the repository and sees that no site is made of it, and that each is told with its place.
Usage: site_test.py SOURCE_FOLDER WORK_FOLDER; exit code 77: Doxygen or its style sheet is not installed."""

import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
HEADER, NOTE, PAGE = "include/batuta/geometry/capsule.hpp", "src/geometry/segment.md", "docs/porting.md"

# File, what is put behind its first mention of a text, the text (none: the end of the file), what has to be told of it.
FAULTS = [
    (HEADER, "\nint undescribed_planted();\n", "namespace batuta {", "undescribed_planted"),
    (HEADER, "\n/// A.\nstruct Planted {\n  int planted_member = 0;\n};\n", "namespace batuta {", "planted_member"),
    (HEADER, "\n/// Planted.\nenum class PlantedEnum { kPlantedValue };\n", "namespace batuta {", "kPlantedValue"),
    (HEADER, "\n/// @ref planted_reference\nint planted();\n", "namespace batuta {", "planted_reference"),
    (HEADER, "\n/// See planted_note.md.\nint also_planted();\n", "namespace batuta {", "planted_note.md"),
    (NOTE, "\n[a link](planted_link.md)\n", "", "planted_link.md"),
    (NOTE, "\n[a heading](segment.md#planted-heading)\n", "", "planted-heading"),
    (PAGE, "\n[a file](../planted_file.cpp)\n", "", "planted_file.cpp"),
    ("README.md", "word\n" * 1300, "", "belongs on a page"),
    (PAGE, "\n![a picture](planted_picture.svg)\n", "", "planted_picture.svg"),
]


def copy_of(source, work):
    """What the site is made of, and what its pages link to."""
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(source, work, ignore=shutil.ignore_patterns("build", ".git", ".cache"))


def plant(work):
    for name, fault, behind, _ in FAULTS:
        file = work / name
        text = file.read_text(encoding="utf-8")
        at = text.index(behind) + len(behind) if behind else len(text)
        file.write_text(text[:at] + fault + text[at:], encoding="utf-8")


def main():
    source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    copy_of(source, work)
    plant(work)
    done = subprocess.run([sys.executable, "-B", work / "toolchains/site.py", work, work / "build/site"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    if done.returncode == SKIPPED:
        return SKIPPED
    told = [line for line in done.stdout.splitlines() if ": error: " in line]
    silent = [word for name, _, _, word in FAULTS if not any(word in line and line.startswith(name) for line in told)]
    foreign = [line for line in told if not any(word in line for _, _, _, word in FAULTS)]
    shutil.rmtree(work)
    for word in silent:
        print(f"planted, and not found: {word}", file=sys.stderr)
    for line in foreign:
        print(f"not planted: {line}", file=sys.stderr)
    return 1 if silent or foreign or done.returncode != 1 else 0


if __name__ == "__main__":
    sys.exit(main())
