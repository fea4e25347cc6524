#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What other tools than CMake read of batuta: manifests of registries, and the list of files for a Makefile. All of it is written
from the library's own build (project.py).
Usage: packages.py write      writes what is committed
       packages.py check      says what of it is not as it would be written; exit code 1: there is something
       packages.py make OUT   writes the archives into the folder OUT"""

import pathlib
import sys

import archives
import makefile
import manifests
import project as source

ROOT = pathlib.Path(__file__).resolve().parents[2]


def committed(project):
    """Path from the root: the text that has to stand there."""
    page = project.root / makefile.PAGE
    return {**manifests.committed(project), makefile.PAGE: makefile.page_with(page.read_text(encoding="utf-8"), project)}


def check(project):
    findings = []
    for name, text in committed(project).items():
        path = project.root / name
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            findings.append(f"{name}: is not what `packages.py write` writes")
    print("\n".join(findings) or "all as it is generated")
    return 1 if findings else 0


def write(project):
    for name, text in committed(project).items():
        path = project.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return 0


def main(words):
    commands = {"check": check, "write": write}
    if len(words) == 2 and words[0] == "make":
        out = pathlib.Path(words[1])
        print("\n".join(str(out / name) for name in archives.make(source.read_project(ROOT), out)))
        return 0
    if len(words) != 1 or words[0] not in commands:
        print(__doc__, file=sys.stderr)
        return 2
    return commands[words[0]](source.read_project(ROOT))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
