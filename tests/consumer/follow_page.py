#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Follows pages to the letter, one after the other in one empty folder outside the tree: a fenced block that begins with a
comment that is a file's name becomes that file, a `sh` block is run; each in its turn.
Usage: follow_page.py SOURCE_FOLDER (PAGE.md HEADING...)...   the sections (## ...) to follow of each page, none: all
The library stands in the folder as `batuta`. Exit code 1: a block failed, with its output and its line; 77: a program
that the blocks call is not installed."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.S | re.M)
NAMED = re.compile(r"^(?://|#) ([\w./-]+)\n")
SKIPPED = 77
PROGRAMS = ["sh", "cmake", "make"]


def blocks(text, headings):
    """(line, language, content) of the fenced blocks of some sections."""
    for match in FENCE.finditer(text):
        above = re.findall(r"^## (.*)$", text[:match.start()], re.M)
        if not headings or (above and above[-1] in headings):
            yield text.count("\n", 0, match.start()) + 1, match.group(1), match.group(2)


def follow(folder, line, language, content):
    """What went wrong with a block, or nothing."""
    named = NAMED.match(content)
    if named and language != "sh":
        file = folder / named.group(1)
        if not file.parent.is_dir():
            return f"there is no folder for {named.group(1)}"
        file.write_text(content, encoding="utf-8")
        print(f"line {line}: wrote {named.group(1)}", flush=True)
        return ""
    if language != "sh":
        return f"a block of '{language}' that is neither a file nor run"
    print(f"line {line}: {content.strip()}", flush=True)
    done = subprocess.run(["sh", "-euc", content], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    print(done.stdout[-6000:], flush=True)
    return f"ended with {done.returncode}" if done.returncode else ""


def pages_of(words):
    """[(page, headings)]"""
    pages = []
    for word in words:
        if word.endswith(".md"):
            pages.append((word, []))
        else:
            pages[-1][1].append(word)
    return pages


def main():
    source, pages = pathlib.Path(sys.argv[1]).resolve(), pages_of(sys.argv[2:])
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if missing:
        print(f"not installed: {missing}")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="batuta-page-") as name:
        folder = pathlib.Path(name)
        (folder / "batuta").symlink_to(source)
        for page, headings in pages:
            text = (source / page).read_text(encoding="utf-8")
            found = list(blocks(text, headings))
            unknown = [heading for heading in headings if f"\n## {heading}\n" not in text]
            if unknown or not any(language == "sh" for _, language, _ in found):
                print(f"{page}: nothing to run, or no section {unknown}", file=sys.stderr)
                return 1
            for line, language, content in found:
                fault = follow(folder, line, language, content)
                if fault:
                    print(f"{page}:{line}: {fault}", file=sys.stderr)
                    return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
