#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the README's generated parts against the code: the example against its source file, the table of figures against
the program that prints it. Usage: readme.py SOURCE_FOLDER FIGURES_PROGRAM [--update]; exit code 1 if they differ."""

import pathlib
import re
import subprocess
import sys


def example(source, name):
    """A source file as a Markdown block, without its licence line."""
    lines = (source / name).read_text().splitlines()
    return "```cpp\n" + "\n".join(line for line in lines if "SPDX" not in line) + "\n```\n"


def generated(source, program):
    """What belongs between the begin and end marks, by the text of the begin mark."""
    table = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    name = "tests/consumer/project/beat.cpp"
    return {f"example {name}": example(source, name), "figures": table}


def filled(text, parts):
    for mark, content in parts.items():
        block = re.compile(rf"(<!-- begin {re.escape(mark)} -->\n).*?(<!-- end -->)", re.S)
        text, count = block.subn(lambda m, new=content: m.group(1) + new + m.group(2), text)
        if count != 1:
            sys.exit(f"README.md: '<!-- begin {mark} -->' ... '<!-- end -->' occurs {count} times, not once")
    return text


def main():
    source, program, *options = sys.argv[1:]
    readme = pathlib.Path(source) / "README.md"
    before = readme.read_text()
    after = filled(before, generated(pathlib.Path(source), program))
    if before == after:
        return 0
    if options == ["--update"]:
        readme.write_text(after)
        return 0
    print("README.md is not what the code says; cmake --build build/host --target readme writes it", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
