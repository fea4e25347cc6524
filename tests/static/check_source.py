#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rules of the source text that no compiler checks: arrows between rooms, words that the core does
without, bounds of loops, the list of deviations, tags of test cases, and names of classes. Usage: check_source.py
arrows|words|bounds|deviations|tags|names FOLDER; prints one line a finding."""

import pathlib
import re
import sys

ROOMS = ["core", "port", "geometry", "mechanics", "detection", "response", "world", "control", "fencing", "haptics",
         "record", "c"]
MAX_LINES = 400
PREPROCESSOR_FILES = {"core/config.hpp", "core/assert.hpp", "core/types.hpp", "geometry/lanes.hpp", "detail/eigen.hpp",
                      "detail/start_check.hpp", "core/lowest_bit.hpp"}

# What, and the words that give it away; matched in code, not in comments or strings.
FORBIDDEN = [
    ("heap", r"(?<!<)\bnew\b|(?<!= )\bdelete\b|\b(?:m|c|re)alloc\b|\bfree\s*\("),
    ("heap", r"\bstd::(?:vector|string|map|set|list|deque|function|any|unordered_\w+|\w+_ptr)\b"),
    ("heap", r"\b(?:Matrix|Vector|RowVector|Array)X+[a-z]*\b|\bEigen::Dynamic\b"),
    ("exception", r"\b(?:throw|try|catch)\b"),
    ("run-time type", r"\b(?:dynamic_cast|typeid)\b"),
    ("printing", r"\b(?:iostream|sstream|fstream|cstdio|stdio\.h|s?n?printf|puts|std::cout|std::cerr)\b"),
    ("clock or thread", r"<(?:chrono|ctime|time\.h|thread|mutex|random)>"),
    ("libm", r"\bstd::(?:a?(?:sin|cos|tan)h?|atan2|exp2?|log(?:2|10|1p)?|pow|hypot|cbrt|fma|fmod|remainder)\b"),
    ("jump", r"\bgoto\b|\bsetjmp\b"),
    ("reserved name", r"\b_[A-Z]\w*|\b(?!__builtin_)\w*__\w*(?<!__)\b"),
]
# Eigen is set up, alike for all, by the one header that includes it.
EIGEN_HEADER = "detail/eigen.hpp"
INCLUDES_EIGEN = re.compile(r"\s*#\s*include\s*[<\"]Eigen/")
FLOAT_LITERAL = re.compile(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][+-]?\d+)?(?![\w.])")
DEVIATION = re.compile(r"\bdeviation: ([\w-]+)")
SUPPRESSION = re.compile(r"NOLINT|cppcheck-suppress")


def code_only(text):
    """The text without comments and string contents, with its lines kept."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'', re.S)

    def blank(match):
        found = match.group(0)
        if found.startswith(("//", "/*")):
            return re.sub(r"[^\n]", " ", found)
        return found

    kept_strings = token.sub(blank, text)
    # Included files are not strings in this sense.
    return re.sub(r'^(?!\s*#\s*include)(.*)$', lambda m: re.sub(r'"[^"]*"', '""', m.group(0)), kept_strings,
                  flags=re.M)


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".hpp", ".cpp", ".h")) if folder.is_dir() else []


def room_of(path, base):
    return path.relative_to(base).parts[0].removesuffix(".h")  # batuta/c.h is all that room c declares


def is_private(path, target):
    """Whether a file of src/ includes a header of src/: of its own folder, or "../room/noun.hpp"."""
    shape = re.fullmatch(r"(\.\./[a-z_]+/)?[a-z_]+\.hpp", target)
    return "include" not in path.parts and bool(shape) and (path.parent / target).is_file()


def check_include(room, path, where, target):
    """A finding for one #include "target" in a file of a room of the library, or None."""
    private = is_private(path, target)
    if private and "/" not in target:
        return None  # a header of the room's own, not for users
    if not private and not target.startswith("batuta/"):
        return f"{where}: includes \"{target}\"; the library includes \"batuta/...\" only"
    other = target.split("/")[1].removesuffix(".h")  # "batuta/room/noun.hpp", "../room/noun.hpp" or "batuta/c.h"
    if other not in ROOMS:
        return f"{where}: includes \"{target}\": there is no such room"
    if ROOMS.index(other) > ROOMS.index(room):
        return f"{where}: room {room} includes \"{target}\" from a later room"
    return None


def check_arrows(root):
    include = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<(batuta/[^>]+)>)')
    findings = []
    for base in (root / "include" / "batuta", root / "src"):
        for path in sources(base):
            room = room_of(path, base)
            if room not in ROOMS:
                findings.append(f"{path.relative_to(root)}: folder {room} is not a room")
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = include.match(line)
                finding = match and check_include(room, path, f"{path.relative_to(root)}:{number}",
                                                  match.group(1) or match.group(2))
                if finding:
                    findings.append(finding)
    return findings + check_port_arrows(root)


# The places of port/, and what each part may read of the others: "platforms/x" is a platform, "shared/x" what they share,
# "programs" those of the host; "template" is what a porter copies.
SHARED_BY_PLATFORMS = "platforms/cortex_m"
SHARED_READS = {"shared/link": set(), "shared/firmware": {"shared/link"}, "shared/hid_pid": {"shared/link"},
                "shared/simulated": set(), "shared/usb_stick": {"shared/hid_pid"}, "shared/drivers": set()}


def place_of(path):
    """The part of port/ that a path leads into: its first folder, of platforms and shared parts the second as well."""
    words = path.split("/")
    return "/".join(words[:2]) if words[0] in ("platforms", "shared") else words[0]


def may_read(own, other):
    """Whether a file of one part of port/ may include a header of another."""
    if own == other:
        return True
    if own.startswith("shared/"):
        return other in SHARED_READS.get(own, set())
    if other.startswith("shared/"):
        return True
    if own == "programs":
        return other == "platforms/host"
    if own == "platforms/web":
        return other == "programs"  # the page plays the host's scripts
    return own.startswith("platforms/") and other == SHARED_BY_PLATFORMS


def check_port_arrows(root):
    """No port reads another port, or the library's insides; what they share reads no port."""
    include = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
    places = {"template", "platforms", "shared", "programs"}
    findings = []
    for path in sources(root / "port"):
        inside = path.relative_to(root / "port").as_posix()
        own = place_of(inside)
        if own.split("/")[0] not in places:
            findings.append(f"{path.relative_to(root)}: port/ has no place {own}")
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = include.match(line)
            target = match.group(1) if match else ""
            first = target.split("/")[0]
            if first in ("src", "..") or (first in places and not may_read(own, place_of(target))):
                findings.append(f"{path.relative_to(root)}:{number}: port {own} includes \"{target}\"")
    return findings


def double_literals(code):
    """(line, literal) of literals of type double: without suffix, outside Scalar(...), in statements that do not
    speak of double."""
    line = 1
    for statement in re.split(r"(;|\)\s*(?:const\s*)?\{)", code):
        if not re.search(r"\bdouble\b", statement):
            bare = re.sub(r"\bScalar\([^()]*\)", lambda m: "\n" * m.group(0).count("\n"), statement)
            for match in FLOAT_LITERAL.finditer(bare):
                yield line + bare[:match.start()].count("\n"), match.group(0)
        line += statement.count("\n")


def check_words(root):
    findings = []
    for path in sources(root / "include") + sources(root / "src"):
        text = path.read_text()
        lines = text.splitlines()
        where = path.relative_to(root)
        if len(lines) > MAX_LINES:
            findings.append(f"{where}: {len(lines)} lines; at most {MAX_LINES}")
        if not text.startswith("// SPDX-License-Identifier: MIT\n"):
            findings.append(f"{where}:1: does not begin with the licence line")
        if path.suffix in (".hpp", ".h") and "#pragma once" not in lines[1:2]:
            findings.append(f"{where}:2: is not #pragma once")
        name = "/".join(path.parts[-2:])
        conditional = name in PREPROCESSOR_FILES
        code = code_only(text)
        findings += [f"{where}:{number}: double literal: {literal}" for number, literal in double_literals(code)]
        for number, line in enumerate(code.splitlines(), 1):
            if DEVIATION.search(lines[number - 1]):
                continue
            for what, pattern in FORBIDDEN:
                for word in re.findall(pattern, line):
                    findings.append(f"{where}:{number}: {what}: {word.strip()}")
            if not conditional and re.match(r"\s*#\s*(?:if|ifdef|ifndef)\b", line):
                findings.append(f"{where}:{number}: preprocessor condition")
            if name != EIGEN_HEADER and INCLUDES_EIGEN.match(line):
                findings.append(f"{where}:{number}: includes Eigen past core/{EIGEN_HEADER}")
    return findings


LOOP = re.compile(r"\b(?:for|while)\s*\((?!\s*false\s*\))")
NOT_A_FUNCTION = re.compile(r"\b(?:namespace|class|struct|union|enum|extern)\b[^()]*$")


def without_preprocessor(code):
    """The code without directives, with its lines kept; what a macro expands to is looked at where it is written
    out."""
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m.group(0)), code, flags=re.M)


def function_starts(code):
    """For each line the line on which the outermost function around it begins, or None; counted from 0."""
    starts = []
    open_braces = []  # the first line of the function that a brace opens, or None for other scopes
    head = ""
    head_line = None
    for number, line in enumerate(code.splitlines()):
        for character in line:
            if character == "{":
                open_braces.append(None if NOT_A_FUNCTION.search(head) else head_line)
            elif character == "}" and open_braces:
                open_braces.pop()
            if character in "{};":
                head, head_line = "", None
                continue
            if not character.isspace() and head_line is None:
                head_line = number
            head += character
        head += " "
        if re.fullmatch(r"\s*(?:public|private|protected):\s*", head):
            head, head_line = "", None
        starts.append(next((start for start in open_braces if start is not None), None))
    return starts


def comment_above(lines, number):
    """The block of comment lines that ends directly above a line."""
    block = []
    for line in reversed(lines[:number]):
        if not line.lstrip().startswith("//"):
            break
        block.append(line)
    return "\n".join(block)


def check_bounds(root):
    """Every loop has its bound beside it, directly above it, or in the comment of its function."""
    findings = []
    for path in sources(root / "include") + sources(root / "src"):
        lines = path.read_text().splitlines()
        code = without_preprocessor(code_only(path.read_text()))
        starts = function_starts(code)
        for number, line in enumerate(code.splitlines()):
            if not LOOP.search(line):
                continue
            named = lines[number] + comment_above(lines, number)
            if starts[number] is not None:
                named += comment_above(lines, starts[number])
            if "Bound" not in named:
                findings.append(f"{path.relative_to(root)}:{number + 1}: a loop without its bound (\"// Bound: ...\")")
    return findings


def check_deviations(root):
    listed_in = root / "tests" / "static" / "DEVIATIONS.md"
    listed = set(re.findall(r"^\| `([\w-]+)` \|", listed_in.read_text(), re.M)) if listed_in.is_file() else set()
    used = {}
    findings = []
    for folder in ("include", "src", "port", "tests/support"):
        for path in sources(root / folder):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                where = f"{path.relative_to(root)}:{number}"
                for name in DEVIATION.findall(line):
                    used.setdefault(name, where)
                if SUPPRESSION.search(line) and not DEVIATION.search(line):
                    findings.append(f"{where}: a suppression without \"deviation: <id>\"")
    findings += [f"{used[name]}: deviation {name} is not in DEVIATIONS.md" for name in sorted(set(used) - listed)]
    findings += [f"DEVIATIONS.md: {name} is not in the code any more" for name in sorted(listed - set(used))]
    return findings


TAG = re.compile(r"\b[TBIRSH]\d\d[a-z]?\b")
TAG_PAGE = "docs/test_cases.md"
THESE = {"check_source.py", "check_source_test.py"}  # they speak of tags of their own


def tags_in_tests(root):
    """Tag -> names of the files below tests/ in which it stands."""
    used = {}
    for path in sorted((root / "tests").rglob("*")):
        if path.suffix not in (".hpp", ".cpp", ".py", ".txt", ".cmake") or path.name in THESE:
            continue
        for tag in TAG.findall(path.read_text(encoding="utf-8")):
            used.setdefault(tag, set()).add(path.name)
    return used


def tags_on_page(root):
    """Tag -> names of files in the last column of its row."""
    page = root / TAG_PAGE
    text = page.read_text(encoding="utf-8") if page.is_file() else ""
    rows = re.findall(r"^\| (\w+) \|.*\| ([^|]*) \|$", text, re.M)
    return {tag: set(re.findall(r"`([^`]+)`", where)) for tag, where in rows if TAG.fullmatch(tag)}


def check_tags(root):
    """Every tag of a test case is on the page, with the files that use it; what is on the page is used."""
    used, defined = tags_in_tests(root), tags_on_page(root)
    findings = [f"{TAG_PAGE}: {tag} ({', '.join(sorted(used[tag]))}) is not defined"
                for tag in sorted(set(used) - set(defined))]
    findings += [f"{TAG_PAGE}: {tag} is in no test" for tag in sorted(set(defined) - set(used))]
    for tag in sorted(set(used) & set(defined)):
        findings += [f"{TAG_PAGE}: {tag} is not in {name}" for name in sorted(defined[tag] - used[tag])]
        findings += [f"{TAG_PAGE}: {tag} is also in {name}" for name in sorted(used[tag] - defined[tag])]
    return findings


CLASS = re.compile(r"(?<!enum )\b(?:class|struct|union)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)\s*(?:final\s*)?"
                   r"(?::(?!:)[^;{}()]*)?\{")

# Names that stand for several classes today. Empty it: each class a name of its own.
TWICE = {}


def classes_in(root):
    """Name of a class or struct, nested ones too -> where it is defined. Specialisations are not counted."""
    found = {}
    for path in sources(root / "include") + sources(root / "src"):
        code = code_only(path.read_text())
        for match in CLASS.finditer(code):
            line = code.count("\n", 0, match.start()) + 1
            found.setdefault(match.group(1), []).append(f"{path.relative_to(root)}:{line}")
    return found


def check_names(root, twice=None):
    """No two classes of the library have one name. What is excused has to be needed."""
    excused = TWICE if twice is None else twice
    double = {name: places for name, places in classes_in(root).items() if len(places) > 1}
    findings = [f"{', '.join(places)}: class {name} is defined {len(places)} times"
                for name, places in sorted(double.items()) if len(places) > excused.get(name, 1)]
    times = {name: len(double.get(name, [0])) for name in excused}
    return findings + [f"check_source.py: {name} is excused {count} times and defined {times[name]} times"
                       for name, count in sorted(excused.items()) if times[name] < count]


CHECKS = {"arrows": check_arrows, "words": check_words, "bounds": check_bounds, "deviations": check_deviations,
          "tags": check_tags, "names": check_names}


def main(arguments):
    if len(arguments) != 2 or arguments[0] not in CHECKS or not pathlib.Path(arguments[1]).is_dir():
        print(f"usage: check_source.py {'|'.join(CHECKS)} FOLDER", file=sys.stderr)
        return 2
    findings = CHECKS[arguments[0]](pathlib.Path(arguments[1]).resolve())
    print("\n".join(findings))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
