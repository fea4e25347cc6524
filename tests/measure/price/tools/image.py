# SPDX-License-Identifier: MIT
"""A linked image as binutils and the linker map tell it: symbols, sections, input sections with their objects."""

import collections
import functools
import pathlib
import re
import subprocess

Symbol = collections.namedtuple("Symbol", "name demangled address size kind")
Section = collections.namedtuple("Section", "name address load size flags")
Piece = collections.namedtuple("Piece", "section address size object output")  # an input section

# "name  address  size  object" of the map; a long name stands on a line of its own before the rest.
PIECE = re.compile(r"^ (\*fill\*|[.\w$][^\s]*)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+)(?: (\S.*))?$")
OUTPUT = re.compile(r"^(\.?[\w.$]+)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+)")
REGION = re.compile(r"^(\w+)\s+0x([0-9a-f]{8,})\s+0x([0-9a-f]{8,})\s*\w*$")


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def demangled(tool, names):
    """mangled -> demangled, with one call of c++filt."""
    names = list(names)
    answer = subprocess.run([tool], input="\n".join(names), check=True, capture_output=True, text=True).stdout
    return dict(zip(names, answer.splitlines()))


class Image:
    """@param tools  paths of nm, objdump and c++filt by those names"""

    def __init__(self, path, tools, map_path=None):
        self.path = pathlib.Path(path)
        self.tools = tools
        self.map_path = pathlib.Path(map_path) if map_path else self.path.with_name(self.path.name + ".map")

    @functools.cached_property
    def symbols(self):
        """Every symbol of the image; those without a size have size 0."""
        rows = []
        for line in run(self.tools["nm"], "--format=sysv", self.path).splitlines():
            fields = [field.strip() for field in line.split("|")]
            if len(fields) == 7 and len(fields[2]) == 1:
                rows.append((fields[0], int(fields[1] or "0", 16), int(fields[4] or "0", 16), fields[2]))
        names = demangled(self.tools["c++filt"], {row[0] for row in rows})
        return [Symbol(name, names[name], address, size, kind) for name, address, size, kind in rows]

    @functools.cached_property
    def sections(self):
        """Output sections that take memory on the target."""
        lines = run(self.tools["objdump"], "-h", self.path).splitlines()
        found = []
        for first, second in zip(lines, lines[1:]):
            fields = first.split()
            if len(fields) == 7 and fields[0].isdigit() and "ALLOC" in second:
                size, address, load = (int(field, 16) for field in fields[2:5])
                found.append(Section(fields[1], address, load, size, second.strip()))
        return found

    @functools.cached_property
    def disassembly(self):
        return run(self.tools["objdump"], "-d", "--no-show-raw-insn", self.path)

    def contents(self, section):
        """The words of a section, little-endian."""
        text = run(self.tools["objdump"], "-s", "-j", section, self.path)
        words = []
        for line in text.splitlines():
            match = re.match(r"^ [0-9a-f]+ ((?:[0-9a-f]+ ){1,4})", line)
            for group in match.group(1).split() if match else []:
                words.append(int.from_bytes(bytes.fromhex(group), "little"))
        return words

    @functools.cached_property
    def pieces(self):
        """Input sections of the image, from the linker map, each with the output section that holds it."""
        text = self.map_path.read_text()
        text = text[text.index("Linker script and memory map"):]
        text = re.sub(r"\n( \S+)\n\s+(?=0x)", r"\n\1 ", text)  # a long name and its numbers in one line
        text = re.sub(r"\n(\.\S+)\n\s+(?=0x)", r"\n\1 ", text)
        known = {section.name for section in self.sections}
        pieces, output = [], ""
        for line in text.splitlines():
            head = OUTPUT.match(line)
            if head:
                output = head.group(1)
            match = PIECE.match(line)
            if match and output in known and int(match.group(3), 16):
                name, address, size, obj = match.groups()
                pieces.append(Piece(name, int(address, 16), int(size, 16), obj or "", output))
        return pieces

    @functools.cached_property
    def regions(self):
        """Memory of the linker script: name -> (origin, length)."""
        text = self.map_path.read_text()
        text = text[text.index("Memory Configuration"):text.index("Linker script and memory map")]
        found = {}
        for line in text.splitlines():
            match = REGION.match(line)
            if match:
                found[match.group(1)] = (int(match.group(2), 16), int(match.group(3), 16))
        return found
