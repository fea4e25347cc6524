#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What toolchains/packages knows of the library is what the build compiles: files, flags and definitions of every command of src/.
Usage: project_test.py SOURCE_FOLDER COMPILE_COMMANDS VERSION FLAGS_OF_THE_TREE"""

import json
import pathlib
import re
import shlex
import sys

SOURCE = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "toolchains/packages"))
import makefile  # noqa: E402
import project as names  # noqa: E402

# What a build adds by itself and says nothing of the library: optimisation, warnings, debugging, paths, and double.
OF_THE_BUILD = re.compile(r"-(?:O.?|W\S*|g\d?|pedantic\S*|I\S*|DNDEBUG|DBATUTA_WITH_DOUBLE=[01]|DBATUTA_ASSERT_LEVEL=\d|fdiagnostics\S*|-param=inline\S*)$")
WITH_A_PATH = {"-isystem", "-o", "-c", "-include"}


def flags_of(command, known):
    words, found = shlex.split(command)[1:], []
    words = iter(words[next(i for i, word in enumerate(words) if word.startswith("-")):])  # behind a launcher
    for word in words:
        if word in WITH_A_PATH:
            next(words)
        elif not OF_THE_BUILD.fullmatch(word) and word not in known:
            found.append(word)
    return found


def findings_of(project, units, known):
    """Lines that say in what the project differs from what is compiled."""
    below = f"{project.root}/src/"
    compiled = {unit["file"]: unit["command"] for unit in units if unit["file"].startswith(below)}
    told = {f"{project.root}/{source}" for source in project.sources()}
    findings = [f"compiled and not told: {file}" for file in sorted(set(compiled) - told)]
    findings += [f"told and not compiled: {file}" for file in sorted(told - set(compiled))]
    stated = {*project.flags, *project.core_flags, *(f"-D{word}" for word in project.core_definitions)}
    for file, command in compiled.items():
        flags = set(flags_of(command, known))
        if flags != stated:
            findings.append(f"{file}: flags {sorted(flags ^ stated)} are in one of the two only")
    return findings


def expect(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def main():
    units, version = json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")), sys.argv[3]
    known = set(shlex.split(sys.argv[4]))
    project = names.read_project(SOURCE)
    expect(project.version == version, f"version {project.version}, CMake's is {version}")
    findings = findings_of(project, units, known)
    expect(not findings, "\n".join(findings))

    # Each of what is told, changed: it must be noticed.
    project.rooms[2].sources.append("planted.cpp")
    expect(findings_of(project, units, known), "a file that nobody compiles is not noticed")
    project.rooms[2].sources = project.rooms[2].sources[1:-1]
    expect(findings_of(project, units, known), "a file that is left out is not noticed")
    project = names.read_project(SOURCE)
    project.flags.pop()
    expect(len(findings_of(project, units, known)) == len(project.sources()), "a flag that is left out is not noticed")

    page = (SOURCE / makefile.PAGE).read_text(encoding="utf-8")
    expect(makefile.page_with(page, names.read_project(SOURCE)) == page, f"{makefile.PAGE} is stale")
    expect(makefile.page_with(page, project) != page, "a page with other flags is not noticed")
    print(len(project.sources()), "sources")


main()
