#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds functions.md against the headers: each public function that takes an argument has its place in the table, and no
other has; what it says is left to the caller has a @pre in its header; each test that it names is there.
Usage: functions_test.py SOURCE_DIR"""

import pathlib
import re
import sys

ROOMS = ["core", "geometry", "mechanics", "detection", "response", "world", "control", "fencing", "haptics", "port", "record"]
# What a scene's type is made of: not called by a user. Folders detail/ are not looked at.
INNER = {"world/bound.hpp", "world/scene_cost.hpp", "fencing/duel_definitions.hpp", "fencing/duel_scene.hpp"}
# A list of members, which tests/unit/record/archive_test.cpp and every archive test go through.
LISTS = {"archive", "last_of", "archive_scene"}
DECLARATION = re.compile(r"^(?P<indent> {0,2})(?! |return|using|static_assert|typedef|friend|if|for|while|else|explicit)"
                         r"[\w:<>,&*\[\]. ]*?[\w>&*] [&*]*(?P<name>[a-z]\w*)\((?!\s*\))")


def code_of(header):
    text = re.sub(r"//[^\n]*", "", header.read_text())
    return re.sub(r"^#[^\n]*(\\\n[^\n]*)*", "", text, flags=re.M).splitlines()


def functions_of(header, with_detail=False):
    """Names of public functions with arguments: free ones, and members of classes; of batuta::detail too, if asked."""
    found = set()
    in_class = hidden = in_detail = False
    for line in code_of(header):
        if line.startswith("namespace detail"):
            in_detail = True
        elif line.startswith("}"):
            in_class = hidden = False
            in_detail = in_detail and line == line.rstrip()  # behind a namespace's there was a comment
        elif re.match(r"(template <.*> )?(class|struct) [^;]*$", line):
            in_class, hidden = not line.rstrip().endswith("}"), False
        elif re.match(r" (private|protected):", line):
            hidden = True
        elif re.match(r" public:", line):
            hidden = False
        match = DECLARATION.match(line)
        if match and not hidden and (with_detail or not in_detail) and (in_class or not match["indent"]) and "=" not in line[:match.start("name")]:
            found.add(match["name"])
    return found - LISTS


def headers(source):
    include = source / "include" / "batuta"
    for path in sorted(path for room in ROOMS for path in (include / room).glob("*.hpp")):
        name = path.relative_to(include).as_posix()
        if name not in INNER:
            yield name, path


def rows_of(table):
    """The rows as header -> list of four sets of words."""
    rows = {}
    for line in table.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 5 and re.fullmatch(r"\w+/\w+\.hpp", cells[0]):
            rows[cells[0]] = [set(re.findall(r"\w+", cell)) for cell in cells[1:]]
    return rows


def complaints(source):
    here = source / "tests" / "extreme"
    rows = rows_of(here / "functions.md")
    tests = "".join(path.read_text() for path in (source / "tests").rglob("*_test.cpp"))
    for name, path in headers(source):
        wanted = functions_of(path)
        told, defined, left, named = rows.pop(name, [set()] * 4)
        yield from (f"{name}: {function} has no place in functions.md" for function in sorted(wanted - told - defined - left))
        yield from (f"{name}: no public function {function}" for function in sorted((told | defined | left) - functions_of(path, True)))
        if left and "@pre" not in path.read_text():
            yield f"{name}: leaves something to the caller, and has no @pre"
        if told and not named:
            yield f"{name}: no test of its answers"
        yield from (f"{name}: no test {test}" for test in sorted(named) if not re.search(rf"\b{test}\b", tests))
    yield from (f"functions.md: {name} is no header of these rooms" for name in sorted(rows))


def main(source):
    found = list(complaints(source))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
