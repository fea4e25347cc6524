# SPDX-License-Identifier: MIT
"""Flash and RAM by room. A piece of the image belongs to the room whose header declares its name (a template of the
world is the world's, whoever instantiates it), else to the library it comes from."""

import collections
import re

Room = collections.namedtuple("Room", "flash ram")

ROOMS = "core port geometry mechanics detection response world fencing".split()
DECLARED = re.compile(r"^(?:class|struct|enum class)\s+(\w+)[^;]*\{|^(?:[\w:<>,\s*&]+\s)(\w+)\(", re.M)
# Of a mangled name in namespace batuta: the first name that is not that of an inner namespace.
MANGLED = re.compile(r"_ZN?K?(?:6batuta)(?:12_GLOBAL__N_1)?(\d+)(.*)")


def declared_names(source):
    """name -> room, by the headers in include/batuta/<room> and the inner ones in src/<room>; what several rooms have a
    function for, such as is_valid(), is left to the library."""
    names = {}
    for room in ROOMS:
        for folder in (source / "src" / room, source / "include" / "batuta" / room):
            for header in sorted(folder.glob("*.hpp")):
                for match in DECLARED.finditer(header.read_text()):
                    names.setdefault(match.group(1) or match.group(2), set()).add(room)
    return {name: min(found) for name, found in names.items() if len(found) == 1}


def base_name(section):
    """The batuta name in a mangled one, or None."""
    match = MANGLED.search(section)
    return match.group(2)[:int(match.group(1))] if match else None


def by_library(obj):
    """Room of an object file by its place."""
    for pattern, room in ((r"libgcc\.a|crt\w*\.o", "libgcc"), (r"lib(c|c_nano|m|g|nosys|rdimon)\w*\.a", "libc"),
                          (r"libstdc\+\+|libsupc\+\+", "libstdc++"), (r"libbatuta_semihosting", "semihosting"),
                          (r"libbatuta_link\b|\bport/shared/link/", "link"),
                          (r"libbatuta_firmware|\bport/shared/firmware/", "firmware"),
                          (r"libbatuta_(?:port_\w+|cortex_m\w*)|\bport/", "platform")):
        if re.search(pattern, obj):
            return room
    library = re.search(r"libbatuta_(\w+)\.a", obj)
    return library.group(1) if library else ("scene" if obj else "padding")


def room_of(piece, names):
    if piece.section == "*fill*" or not piece.object:
        return "padding"
    return names.get(base_name(piece.section) or "", by_library(piece.object))


def kind_of(section):
    """(counts as flash, counts as RAM); the stack's own place is neither, it has a figure of its own."""
    if re.search("stack|heap", section.name):
        return False, False
    stored = "CONTENTS" in section.flags
    moved = section.address != section.load
    writable = "READONLY" not in section.flags and "CODE" not in section.flags
    return stored, moved or writable


def by_room(image, names):
    """room -> Room in bytes, "total" included: of the sections; what the map does not place in them is "other"."""
    kinds = {section.name: kind_of(section) for section in image.sections}
    sums = collections.defaultdict(lambda: [0, 0])
    for piece in image.pieces:
        room = room_of(piece, names)
        for i, counts in enumerate(kinds[piece.output]):
            sums[room][i] += piece.size if counts else 0
    total = [sum(section.size for section in image.sections if kinds[section.name][i]) for i in range(2)]
    placed = [sum(room[i] for room in sums.values()) for i in range(2)]
    if total != placed:
        sums["other"] = [total[i] - placed[i] for i in range(2)]
    sums["total"] = total
    return {room: Room(*pair) for room, pair in sums.items()}


def biggest(image, names, count):
    """The largest symbols: (size, room, readable name)."""
    pieces = sorted((piece.address, piece) for piece in image.pieces)
    found = []
    for symbol in sorted(image.symbols, key=lambda s: -s.size)[:count]:
        inside = [piece for address, piece in pieces if address <= symbol.address & ~1 < address + piece.size]
        found.append((symbol.size, room_of(inside[0], names) if inside else "?", symbol.demangled))
    return found
