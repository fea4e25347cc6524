#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the README's generated parts against the code: the example against its source file, the table of figures against
the program that prints it, and the table of the report against the last quick one, but for its times.
Usage: readme.py SOURCE_FOLDER FIGURES_PROGRAM [--update], or readme.py SOURCE_FOLDER --report REPORT_FOLDER [--update];
exit code 1 if they differ, 77 if there is no report to compare with."""

import pathlib
import re
import shutil
import subprocess
import sys


def example(source, name):
    """A source file as a Markdown block, without its licence line."""
    lines = (source / name).read_text().splitlines()
    return "```cpp\n" + "\n".join(line for line in lines if "SPDX" not in line) + "\n```\n"


PICTURE = "tests/measure/report/error_against_cost.svg"  # in the repository; drawn by the report
SKIPPED = 77


def from_code(source, program):
    """What belongs between the begin and end marks, by the text of the begin mark."""
    table = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    name = "tests/consumer/project/beat.cpp"
    return {f"example {name}": example(source, name), "figures": table}


def from_report(report):
    return {"report": f"![Error of the time of contact against cost]({PICTURE})\n\n" + (report / "readme.md").read_text()}


def filled(text, parts):
    for mark, content in parts.items():
        block = re.compile(rf"(<!-- begin {re.escape(mark)} -->\n).*?(<!-- end -->)", re.S)
        text, count = block.subn(lambda m, new=content: m.group(1) + new + m.group(2), text)
        if count != 1:
            sys.exit(f"README.md: '<!-- begin {mark} -->' ... '<!-- end -->' occurs {count} times, not once")
    return text


def without_times(text):
    """Ratios of times, which differ from run to run, are written "12 ×"."""
    return re.sub(r"[\d.]+ ×", "×", text)


def is_same(before, after, source):
    return without_times(before) == without_times(after) and (source / PICTURE).is_file()


def main():
    options = [word for word in sys.argv[1:] if word != "--update"]
    source = pathlib.Path(options[0])
    report = pathlib.Path(options[2]) if options[1] == "--report" else None
    if report and not (report / "readme.md").is_file():
        print("README.md: no report to compare with; cmake --workflow --preset report makes one", file=sys.stderr)
        return SKIPPED
    parts = from_report(report) if report else from_code(source, options[1])
    before = (source / "README.md").read_text()
    after = filled(before, parts)
    if "--update" in sys.argv:
        (source / "README.md").write_text(after)
        if report and (report / "search_double.svg").is_file():
            shutil.copyfile(report / "search_double.svg", source / PICTURE)
        return 0
    if is_same(before, after, source):
        return 0
    target = "readme-report" if report else "readme"
    print(f"README.md is not what the code says; cmake --build build/host --target {target} writes it", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
