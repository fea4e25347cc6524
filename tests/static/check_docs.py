#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What pages say about files, headings, tests and names, and no compiler checks. Usage: check_docs.py FOLDER; prints
one line a finding.

- A relative link of README.md, docs/*.md, src/**/*.md or port/**/*.md leads to a file, its #fragment to a heading.
- docs/paper.md: what stands in backticks is a file, a test of tests/, or a name that the code has."""

import pathlib
import re
import sys

PAGES = ["README.md", "docs/*.md", "src/**/*.md", "port/**/*.md"]
PAPER = "docs/paper.md"
CODE = ["include", "src", "port", "tests"]
CODE_SUFFIXES = {".hpp", ".cpp", ".py", ".cmake", ".txt", ".h"}
FILE_SUFFIXES = CODE_SUFFIXES | {".md", ".csv", ".svg", ".json", ".ld"}

FENCE = re.compile(r"^ {0,3}(`{3,}|~{3,}).*?(?:^ {0,3}\1[`~]*[ \t]*$|\Z)", re.M | re.S)
INLINE_CODE = re.compile(r"(`+)(.+?)\1", re.S)
LINK = re.compile(r"\]\(\s*<?([^()\s<>]+(?:\([^()\s]*\)[^()\s<>]*)?)>?(?:\s+\"[^\"]*\")?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]]+\]:\s*<?(\S+?)>?\s*$", re.M)
HEADING = re.compile(r"^ {0,3}#{1,6}[ \t]+(.+?)(?:[ \t]+#+)?[ \t]*$", re.M)
SCHEME = re.compile(r"[a-zA-Z][a-zA-Z0-9+.-]*:")
TEST = re.compile(r"\b(?:TYPED_)?(?:TEST(?:_F|_P)?|RC_GTEST(?:_TYPED)?(?:_FIXTURE)?_PROP)"
                  r"\(\s*(\w+)\s*,\s*(\w+)")


def blanked(match):
    """The same number of lines, nothing in them."""
    return re.sub(r"[^\n]", " ", match.group(0))


def without_fences(text):
    return FENCE.sub(blanked, text)


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def slugs(text):
    """The fragments of a page: its headings as the usual viewers name them, and anchors that it sets itself."""
    text = without_fences(text)
    found, seen = set(re.findall(r"\b(?:id|name)=\"([^\"]+)\"", text)), {}
    for match in HEADING.finditer(text):
        title, own = re.subn(r"\s*\{#([\w-]+)\}$", r"", match.group(1))
        if own:
            found.add(re.search(r"\{#([\w-]+)\}$", match.group(1)).group(1))
        title = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", title)
        slug = re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(f"{slug}-{count}" if count else slug)
    return found


def links(text):
    """(line, target) of the links of a page; what is code is none."""
    text = INLINE_CODE.sub(blanked, without_fences(text))
    for pattern in (LINK, REFERENCE):
        for match in pattern.finditer(text):
            yield line_of(text, match.start()), match.group(1)


def check_link(root, page, target):
    """What is wrong with a link of a page, or None."""
    if SCHEME.match(target):
        return None
    name, _, fragment = target.partition("#")
    if name.startswith("/"):
        return "is not relative"
    path = (page.parent / name).resolve() if name else page.resolve()
    if root.resolve() not in [path, *path.parents]:
        return "leads out of the project"
    if not path.exists():
        return "leads to no file"
    if fragment and path.suffix == ".md" and fragment not in slugs(path.read_text()):
        return "leads to no heading"
    return None


def check_links(root):
    findings = []
    for pattern in PAGES:
        for page in sorted(root.glob(pattern)):
            for line, target in links(page.read_text()):
                wrong = check_link(root, page, target)
                if wrong:
                    findings.append(f"{page.relative_to(root)}:{line}: {target} {wrong}")
    return findings


class Code:
    """The tests and the names of the code."""

    def __init__(self, root):
        own = {"check_docs.py", "check_docs_test.py"}
        texts = [path.read_text(errors="replace") for folder in CODE for path in sorted((root / folder).rglob("*"))
                 if path.suffix in CODE_SUFFIXES and path.name not in own]
        self.text = "\n".join(texts)
        self.tests = {f"{suite}.{name}" for suite, name in TEST.findall(self.text)}
        self.words = set(re.findall(r"\w+", self.text))

    def has_name(self, name):
        """Whether each part of a name like `Suite::member()` or `Search<float>` is a word of the code."""
        parts = re.findall(r"\w+", name)
        return bool(parts) and (name in self.text or all(part in self.words for part in parts))


def check_name(root, code, name):
    """What is wrong with a word in backticks, or None."""
    if pathlib.PurePath(name).suffix in FILE_SUFFIXES or "/" in name:
        return None if (root / name).exists() else "is no file"
    if re.fullmatch(r"[A-Z]\w*\.[A-Z]\w*", name):
        return None if name in code.tests else "is no test"
    if re.fullmatch(r"[a-z_]\w*\.\w+", name):  # of ctest, as tests/<folder>/CMakeLists.txt names it
        return None if code.has_name(name.split(".")[1]) else "is no test"
    return None if code.has_name(name) else "is no name of the code"


def check_paper(root):
    page = root / PAPER
    if not page.is_file():
        return []
    code = Code(root)
    findings = []
    text = without_fences(page.read_text())
    for match in INLINE_CODE.finditer(text):
        name = match.group(2).strip()
        wrong = None if re.search(r"\s", name) else check_name(root, code, name)  # a blank: a command
        if wrong:
            findings.append(f"{PAPER}:{line_of(text, match.start())}: {name} {wrong}")
    return findings


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(sys.argv[1])
    findings = check_links(root) + check_paper(root)
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
