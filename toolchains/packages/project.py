# SPDX-License-Identifier: MIT
"""The one source of the library's name, version, files and flags: what CMake itself is told, in CMakeLists.txt, src/CMakeLists.txt
and src/<room>/CMakeLists.txt. tests/packages holds it against the compile commands of the build."""

import dataclasses
import pathlib
import re

COMMENT = re.compile(r"#[^\n]*")


@dataclasses.dataclass
class Room:
    name: str
    sources: list  # below src/<name>
    on: list  # rooms that it stands on


@dataclasses.dataclass
class Project:
    root: pathlib.Path
    name: str
    version: str
    description: str
    rooms: list
    flags: list  # of every file, the user's too
    core_flags: list  # of the library's sources, beside those
    core_definitions: list

    def sources(self):
        """Paths from the root, rooms in their order."""
        return [f"src/{room.name}/{source}" for room in self.rooms for source in room.sources]

    def headers(self):
        """What a user may include, below include/."""
        base = self.root / "include"
        return sorted(path.relative_to(base).as_posix() for path in base.rglob("*") if path.suffix in (".hpp", ".h"))

    def private_headers(self):
        """What only sources include, from the root."""
        found = (path for path in (self.root / "src").rglob("*") if path.suffix in (".hpp", ".h"))
        return sorted(path.relative_to(self.root).as_posix() for path in found)

    def files(self):
        """All that a compiler reads of the library, from the root."""
        return self.sources() + self.private_headers() + [f"include/{header}" for header in self.headers()]


def read_cmake(path):
    return COMMENT.sub("", path.read_text(encoding="utf-8"))


def words_of(text, command, first):
    """Words of the call `command(first ...)`, those of generator expressions and warnings left out."""
    match = re.search(rf"\b{command}\(\s*{re.escape(first)}\s+([^)]*)\)", text)
    if not match:
        raise SystemExit(f"there is no {command}({first} ...)")
    return [word for word in re.sub(r"\$<[^\n]*", "", match.group(1)).split() if not word.startswith("-W")]


def read_room(root, name):
    words = words_of(read_cmake(root / "src" / name / "CMakeLists.txt"), "batuta_room", name)
    on = words.index("ON") if "ON" in words else len(words)
    return Room(name, words[words.index("SOURCES") + 1:on], words[on + 1:])


def read_project(root):
    root = pathlib.Path(root).resolve()
    top, src = read_cmake(root / "CMakeLists.txt"), read_cmake(root / "src/CMakeLists.txt")
    name, version = re.search(r"\bproject\((\w+) VERSION ([\d.]+)", top).groups()
    description = re.search(r'\bDESCRIPTION "([^"]*)"', top).group(1)
    rooms = re.search(r"\bforeach\(room ([^)]*)\)", src).group(1).split()
    standard = re.search(r"\bcxx_std_(\d+)", src).group(1)
    flags = words_of(src, "target_compile_options", "batuta_config INTERFACE")
    core = words_of(src, "target_compile_options", "batuta_core_flags INTERFACE")
    definitions = words_of(src, "target_compile_definitions", "batuta_core_flags INTERFACE")
    return Project(root, name, version, description, [read_room(root, room) for room in rooms],
                   [f"-std=c++{standard}", *flags], core, definitions)
