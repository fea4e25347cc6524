#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the ```cpp blocks of a page into a frame that says what stands around them, so that a compiler can read them.
Usage: fill_page.py PAGE FRAME OUTPUT. A line `// block N` of the frame becomes block N of the page, counted from 1, with
a #line that names the page. Exit code 1: a block of the page is in the frame not at all or twice, or is none."""

import pathlib
import re
import sys

BLOCK = re.compile(r"^```cpp\n(.*?)^```$", re.S | re.M)
PLACE = re.compile(r"^// block (\d+)\n", re.M)


def main():
    page, frame, output = map(pathlib.Path, sys.argv[1:])
    text, outline = page.read_text(encoding="utf-8"), frame.read_text(encoding="utf-8")
    blocks = {str(number): (text.count("\n", 0, match.start()) + 2, match.group(1))
              for number, match in enumerate(BLOCK.finditer(text), 1)}
    places = PLACE.findall(outline)
    if not blocks or sorted(places) != sorted(blocks):
        print(f"{frame}: has blocks {places}, the page {page} has {list(blocks)}", file=sys.stderr)
        return 1

    def put(match):
        line, content = blocks[match.group(1)]
        after = outline.count("\n", 0, match.end()) + 1
        return f'#line {line} "{page.as_posix()}"\n{content}#line {after} "{frame.as_posix()}"\n'

    output.write_text(PLACE.sub(put, outline), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
