# SPDX-License-Identifier: MIT
"""What Doxygen reads: a copy of the pages, notes and headers, line for line the same text, made plain to Doxygen.
- A header's comment below `#pragma once` becomes the documentation of the file.
- A heading gets the name by which a browser of the repository knows it, and a link to it leads there.
- A page or a note in code marks (`docs/porting.md`, or `stick.md` beside it) becomes a link to it.
- A link to any other file of the repository, or a picture, becomes one to a copy of it in the site.
What is broken is a fault: a link, a heading, a picture, a note that is named and not there."""

import os
import pathlib
import re
import shutil

FOLDERS = ["docs", "src", "port"]
NOTES = ["src", "port"]  # what stands below these is a note, what stands in docs/ a page
TOP = ["README.md", "CHANGELOG.md"]
MOST_LINES, MOST_WORDS = 150, 1300  # of the README: it is read in four minutes
INDEX = "docs/index.md"
PRAGMA = "#pragma once"
# A World is an engine, chosen by the scene, and shows the members of that one.
ENGINE = "general_world.hpp"
WORLD = re.compile(r"(class World : public )[^{;]*?( *\{)")

FENCE = re.compile(r"^\s*(```|~~~)")
HEADING = re.compile(r"^(#{1,6}) +(.*?) *$")
CODE = re.compile(r"(`[^`]*`)")
BARE_NOTE = re.compile(r"(?<!\]\()(?<![\w./\[-])((?:[\w-]+/)*[\w-]+\.md)\b(?!\])")
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)#\s]*)(?:#([^)\s]*))?\)")
NAMED_NOTE = re.compile(r"(?<![\w./-])((?:[\w-]+/)*[\w-]+\.md)\b")
MADE_BY_PROGRAMS = re.compile(r"build/|report\.md$")  # no files of the repository


def is_shown(path):
    """Whether a header belongs to the interface."""
    return path.name == ENGINE or "detail" not in path.parts


def header(text, is_engine):
    """The comment lines that follow the pragma become a documentation comment."""
    if is_engine:
        text = text.replace("namespace batuta::detail {", "namespace batuta {")
        text = text.replace("namespace detail {", 'extern "C++" {')
    lines = WORLD.sub(r"\1GeneralWorld<SceneT>\2", text).split("\n")
    if PRAGMA not in lines:
        return "\n".join(lines)
    at = end = lines.index(PRAGMA) + 1
    while end < len(lines) and re.match(r"//(?!/)", lines[end]):
        end += 1
    if end > at:
        lines[at - 1:end] = ["/// @file"] + ["/" + line for line in lines[at:end]]
    return "\n".join(lines)


def page_name(note):
    """The name that Doxygen gives the page of a Markdown file."""
    return "md_" + note[:-len(".md")].replace("/", "_")


def slug(heading):
    """The name of a heading in a browser of the repository."""
    words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
    return re.sub(r"[^\w -]", "", words).strip().replace(" ", "-")


def plain_lines(text):
    """(index, line) of the lines outside of code."""
    fenced = False
    for i, line in enumerate(text.split("\n")):
        if FENCE.match(line):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            yield i, line


def paragraphs(text):
    """(first line, line behind the last) of the stretches without code, empty lines and headings; each heading."""
    first = last = 0
    for i, line in plain_lines(text):
        if i != last or not line or HEADING.match(line) or HEADING.match(text.split("\n")[first]):
            if last > first:
                yield first, last
            first = i
        last = i + 1
    if last > first:
        yield first, last


def headings(text):
    """Index of the line -> name of the heading, of a page; one that comes again is counted."""
    found, seen = {}, {}
    for i, line in plain_lines(text):
        match = HEADING.match(line)
        if match:
            name = slug(match.group(2))
            seen[name] = seen.get(name, -1) + 1
            found[i] = f"{name}-{seen[name]}" if seen[name] else name
    return found


class Stage:
    """A folder to which the repository's pages, notes and headers are copied."""

    def __init__(self, source, stage, html):
        self.source, self.stage, self.html = source, stage, html
        self.faults = []
        self.texts = {path.relative_to(source).as_posix(): path.read_text(encoding="utf-8") for path in self.markdown()}
        self.names = {note: headings(text) for note, text in self.texts.items()}

    def markdown(self):
        """The pages and notes of the site."""
        found = [self.source / name for name in TOP if (self.source / name).is_file()]
        for folder in FOLDERS:
            found += sorted((self.source / folder).rglob("*.md"))
        return found

    def headers(self):
        """The headers of the interface."""
        return [path for path in (self.source / "include").rglob("*.hpp") if is_shown(path)]

    def note(self, name, beside):
        """The note that somebody names: by its path, or by its file name where that is enough."""
        normal = os.path.normpath((pathlib.PurePosixPath(beside).parent / name).as_posix())
        if normal in self.texts:
            return normal
        ends = [note for note in self.texts if note == name or note.endswith("/" + name)]
        return ends[0] if len(ends) == 1 else None

    def fault(self, path, line, text):
        self.faults.append(f"{path}:{line + 1}: error: {text}")

    def check_names(self, text, path):
        """Every note that is named must be there."""
        for i, line in enumerate(text.split("\n")):
            for name in NAMED_NOTE.findall(line):
                known = MADE_BY_PROGRAMS.match(name) or (self.source / name).is_file() or self.note(name, path)
                if not known:
                    self.fault(path, i, f"there is no note or page '{name}', or several: say its folder")

    def copied(self, file):
        """The place in the site of a copy of a file."""
        name = file.resolve().relative_to(self.source.resolve()).as_posix()
        copy = self.html / "files" / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)
        return f"files/{name}"

    def linked(self, match, path, line):
        """A link or a picture as it has to be in the copy."""
        before, target, anchor = match.groups()
        if re.match(r"\w+:", target) or not (target or anchor):
            return match.group(0)
        note = path if not target else self.note(target, path) if target.endswith(".md") else None
        if note and not anchor:
            return self.page_link(before, note, path)
        if note and anchor in self.names[note].values():
            return f"{before}@ref {self.label(note, anchor)})"
        file = (self.source / path).parent / target
        if file.is_file() and not anchor:
            return f"{before}{self.copied(file)})"
        if not file.is_dir():
            self.fault(path, line, f"broken link: {' '.join(match.group(0).split())}")
        return match.group(0)

    @staticmethod
    def page_link(before, note, path):
        """A link to a page. What the page of pages lists stands below it in the tree."""
        if note == TOP[0]:
            return f"{before}index.html)"
        if path == INDEX and not note.startswith(tuple(NOTES)):
            return f'@subpage {page_name(note)} "{before[1:-2]}"'
        return f"{before}@ref {page_name(note)})"

    @staticmethod
    def label(note, name):
        """The name of a heading among those of all pages."""
        return f"{page_name(note)}_{name}".replace("-", "_")

    def named_link(self, shown, name, path):
        """A note that is named, as a link to it."""
        note = self.note(name, path)
        return f"[{shown}]({os.path.relpath(note, pathlib.PurePosixPath(path).parent)})" if note else shown

    def with_links(self, line, path):
        """A line in which every note that is named, in code marks or not, is a link."""
        parts = CODE.split(line)
        for i, part in enumerate(parts):
            if i % 2 == 0:
                parts[i] = BARE_NOTE.sub(lambda m: self.named_link(m.group(0), m.group(1), path), part)
            elif part.endswith(".md`") and not parts[i - 1].endswith("["):
                parts[i] = self.named_link(part, part.strip("`"), path)
            elif "'" in part:
                parts[i] = f"`{part}`"  # between single marks Doxygen takes a dash, as in f', for the other end
        return "".join(parts)

    def page(self, path):
        lines = self.texts[path].split("\n")
        for first, last in paragraphs(self.texts[path]):
            text = "\n".join(lines[first:last])
            if not HEADING.match(text):
                text = self.with_links(text, path)
            lines[first:last] = self.with_targets(text, path, first).split("\n")
        for i, name in self.names[path].items():
            # Doxygen names a page by its title. What has a name stands in the tree, with its code marks as they are.
            if not lines[i].startswith("# ") and path not in (TOP[0], INDEX):
                lines[i] = lines[i].replace("`", "") + f" {{#{self.label(path, name)}}}"
        return "\n".join(lines)

    def with_targets(self, text, path, first):
        """A paragraph whose links are those of the copy; one whose words stand on two lines begins on the second."""
        def linked(match):
            ends = match.group(0).count("\n")
            return "\n" * ends + self.linked(match, path, first + text.count("\n", 0, match.start())).replace("\n", " ")
        return LINK.sub(linked, text)

    def put(self, path, text):
        out = self.stage / path
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(text, encoding="utf-8")

    def fill(self):
        """Copies all; what is broken is in `faults` after that."""
        lines, words = len(self.texts[TOP[0]].splitlines()), len(self.texts[TOP[0]].split())
        if lines > MOST_LINES or words > MOST_WORDS:
            self.fault(TOP[0], lines - 1, f"{lines} lines and {words} words: what is more belongs on a page")
        worlds = 0
        for path, text in self.texts.items():
            self.check_names(text, path)
            below = "\nAll of them: @subpage md_docs_notes\n" if path == INDEX else ""
            self.put(path, self.page(path) + below)
        for file in self.headers():
            path, text = file.relative_to(self.source).as_posix(), file.read_text(encoding="utf-8")
            self.check_names(text, path)
            self.put(path, header(text, file.name == ENGINE))
            worlds += len(WORLD.findall(text))
        if worlds != 1:
            self.faults.append(f"include: error: 'class World : public ...' stands there {worlds} times, not once")
        self.put("docs/notes.md", self.contents())

    def contents(self):
        """The page above the notes: what each room and each port has."""
        lines, folder = ["# Derivation notes", ""], None
        for note in self.texts:
            path = pathlib.PurePosixPath(note)
            if path.parts[0] not in NOTES:
                continue
            if path.parent != folder:
                folder = path.parent
                lines += ["", f"## {folder}", ""]
            lines.append(f"- @subpage {page_name(note)}")
        return "\n".join(lines) + "\n"
