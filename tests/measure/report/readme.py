#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the generated blocks of the repository's pages against the code: the README's example against its source file, the
table of figures of docs/cost.md against the program that prints it, and the blocks of the report against the last quick one, but for the
times. A block stands between "<!-- begin MARK -->" and "<!-- end -->"; FILE:MARK names it, such as docs/error.md:report.
Usage: readme.py SOURCE_FOLDER FIGURES_PROGRAM [--update], or
readme.py SOURCE_FOLDER --report REPORT_FOLDER FILE:MARK... [--update];
exit code 1 if they differ, or if the host was too busy for times that are to be written; 77 if there is no report to compare
with."""

import pathlib
import re
import shutil
import subprocess
import sys


def example(source, name):
    """A source file as a Markdown block, without its licence line."""
    lines = (source / name).read_text().splitlines()
    return "```cpp\n" + "\n".join(line for line in lines if "SPDX" not in line) + "\n```\n"


PICTURES = pathlib.PurePosixPath("tests/measure/report")  # folder in the repository of the pictures that blocks show
SHOWN = re.compile(r"(!\[[^]]*\]\()([^)/]+\.svg)(\))")
BUSY = "busy.txt"  # written by render.py
SKIPPED = 77


def from_code(source, program):
    """What belongs between the begin and end marks, by page and by the text of the begin mark."""
    table = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    name = "tests/consumer/project/beat.cpp"
    return {"README.md": {f"example {name}": example(source, name)}, "docs/cost.md": {"figures": table}}


def from_report(report, page, mark):
    """The block of a report for a page, whose pictures it names as that page sees them."""
    up = pathlib.PurePosixPath(*[".."] * len(pathlib.PurePosixPath(page).parent.parts))
    text = (report / "blocks" / f"{mark}.md").read_text()
    return SHOWN.sub(lambda m: m.group(1) + str(up / PICTURES / m.group(2)) + m.group(3), text)


def pictures_of(report, mark):
    return [m.group(2) for m in SHOWN.finditer((report / "blocks" / f"{mark}.md").read_text())]


def filled(text, parts, page="README.md"):
    for mark, content in parts.items():
        block = re.compile(rf"(<!-- begin {re.escape(mark)} -->\n).*?(<!-- end -->)", re.S)
        text, count = block.subn(lambda m, new=content: m.group(1) + new + m.group(2), text)
        if count != 1:
            sys.exit(f"{page}: '<!-- begin {mark} -->' ... '<!-- end -->' occurs {count} times, not once")
    return text


def without_times(text):
    """Ratios of times, which differ from run to run, are written "12 ×"."""
    return re.sub(r"[\d.]+ ×", "×", text)


def by_page(blocks):
    """{file: marks} of FILE:MARK."""
    pages = {}
    for block in blocks:
        page, _, mark = block.rpartition(":")
        pages.setdefault(page, []).append(mark)
    return pages


def update(source, pages, report):
    """Writes the blocks, and copies the pictures that they show."""
    for page, parts in pages.items():
        path = source / page
        path.write_text(filled(path.read_text(), parts, page))
        for picture in [name for mark in parts if report for name in pictures_of(report, mark)]:
            if (report / picture).is_file():
                shutil.copyfile(report / picture, source / PICTURES / picture)


def differing(source, pages, report):
    """The pages that are not what the code or the report says, but for times, or whose pictures are not there."""
    for page, parts in pages.items():
        before = (source / page).read_text()
        pictures = [name for mark in parts if report for name in pictures_of(report, mark)]
        there = all((source / PICTURES / name).is_file() for name in pictures)
        if without_times(before) != without_times(filled(before, parts, page)) or not there:
            yield page


def say(sentence):
    print(sentence, file=sys.stderr)


def main():
    first, *options = [word for word in sys.argv[1:] if word != "--update"]
    source, report = pathlib.Path(first), None
    if options[0] == "--report":
        report = pathlib.Path(options[1])
        wanted = by_page(options[2:])
        absent = [mark for marks in wanted.values() for mark in marks if not (report / "blocks" / f"{mark}.md").is_file()]
        if absent:
            say(f"no report to compare with: it has no {', '.join(absent)}; cmake --workflow --preset report makes one")
            return SKIPPED
        pages = {page: {mark: from_report(report, page, mark) for mark in marks} for page, marks in wanted.items()}
    else:
        pages = from_code(source, options[0])
    if "--update" in sys.argv:
        if report and (report / BUSY).is_file():
            say((report / BUSY).read_text() + "nothing is written: run the report again when the host has nothing else to do")
            return 1
        update(source, pages, report)
        return 0
    others = list(differing(source, pages, report))
    target = "readme-report" if report else "readme"
    for page in others:
        say(f"{page} is not what the code says; cmake --build build/host --target {target} writes it")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
