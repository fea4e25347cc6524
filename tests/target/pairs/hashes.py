# SPDX-License-Identifier: MIT
"""The hash of every query that batuta_digest writes, and where two such files differ first."""
import struct

SECTIONS = ("toc", "translation", "stepping", "distance", "impulse", "duel", "flight", "scenes", "tumbling")
SEQUENCES = {"duel": ("recording", "step"), "flight": ("body", "block of steps"), "scenes": ("scene", "step"),
             "tumbling": ("body", "block of steps")}
RECORD = struct.Struct("<IIQ")  # section, index, hash


def read(path):
    """[(section name, index, hash)] in the order in which the queries were answered."""
    with open(path, "rb") as file:
        content = file.read()
    return [(SECTIONS[section], index, value) for section, index, value in RECORD.iter_unpack(content)]


def counts(records):
    """How many queries of each section there are."""
    tally = dict.fromkeys(SECTIONS, 0)
    for section, _, _ in records:
        tally[section] += 1
    return tally


def first_difference(reference, other):
    """(section, index) of the first query that is answered differently, or by one of them only; None: none."""
    for ours, theirs in zip(reference, other):
        if ours != theirs:
            return ours[:2]
    if len(reference) != len(other):
        longer = max(reference, other, key=len)
        return longer[min(len(reference), len(other))][:2]
    return None


def name_of(section, index):
    """A query as a reader finds it: the line of the query file, or the step of a recording."""
    if section not in SEQUENCES:
        return f"{section}, line {index}"
    of, place = SEQUENCES[section]
    return f"{section}, {of} {index >> 24}, {place} {index & 0xFFFFFF}"


def first_field(ours, theirs):
    """Of two answers, each a list of lines "field bits": (number of the line, ours, theirs) where they differ."""
    for number, (one, other) in enumerate(zip(ours, theirs)):
        if one != other:
            return number, one, other
    shorter = min(len(ours), len(theirs))
    if len(ours) == len(theirs):
        return None
    return shorter, *((lines[shorter] if len(lines) > shorter else "(nothing)") for lines in (ours, theirs))
