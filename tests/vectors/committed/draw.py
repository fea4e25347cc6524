# SPDX-License-Identifier: MIT
"""Draws the committed part of the exact answers from the whole files; README.md beside this says what they are.

usage: draw.py WHOLE PART            write toc.csv, dist.csv and resp.csv of folder PART from those of folder WHOLE
       draw.py --check WHOLE PART    compare PART with what would be drawn; exit status 1 where it differs

The rule has no chance in it. In each family, in this order: the rows that are extreme in one of the measures of the
file (EXTREMES of each measure), the first EXTREMES of each outcome, then rows at equal distances, in proportion to the
family's size, until the file has its number of rows. Lines are copied as they are, in the order of the whole file.
"""
import csv
import os
import struct
import sys

EXTREMES = 2
ROWS = {"toc.csv": 2000, "dist.csv": 2000, "resp.csv": 500}


def number(bits):
    """The float whose bits are written without trailing zeros."""
    return struct.unpack(">f", bytes.fromhex(bits.ljust(8, "0")))[0]


def least(value, where=lambda row: True):
    """Measure: rows with the least value first. Rows where it says nothing are left out."""
    def measure(rows):
        found = [(value(row), place) for place, row in rows if where(row)]
        return [place for _, place in sorted(found)]
    return measure


def greatest(value, where=lambda row: True):
    return least(lambda row: -value(row), where)


def column(name):
    return lambda row: float(row[name])


def touches(row):
    return row["kind"] == "1"


def share_of_step(row):
    return float(row["t"]) / number(row["T"])


def mass_ratio(row):
    return number(row["Am"]) / number(row["Bm"])


def both_finite(row):
    return "7f8" not in (row["Am"], row["Bm"])


# What is hard: gaps and overlaps next to nothing, short touches, slow approaches, contacts at the ends of a step;
# nearly parallel axes and least distances; unequal masses, grazing and receding blows, and much or little restitution.
MEASURES = {
    "toc.csv": [
        least(lambda row: abs(float(row["gmin"])), lambda row: row["kind"] == "0"),
        least(lambda row: abs(float(row["gmin"])), touches),
        least(column("dur"), touches),
        least(lambda row: abs(float(row["rate"])), touches),
        least(share_of_step, touches),
        greatest(share_of_step, touches),
    ],
    "dist.csv": [
        least(column("sin2"), lambda row: float(row["sin2"]) > 0),
        least(column("d"), lambda row: float(row["d"]) > 0),
        greatest(column("d")),
    ],
    "resp.csv": [
        least(mass_ratio, both_finite),
        greatest(mass_ratio, both_finite),
        least(lambda row: abs(float(row["vrel"]))),
        greatest(lambda row: abs(float(row["j"]))),
        least(lambda row: number(row["e"])),
        greatest(lambda row: number(row["e"])),
    ],
}
OUTCOMES = {
    "toc.csv": lambda row: row["kind"],
    "dist.csv": lambda row: (row["cls"], row["unique"]),
    "resp.csv": lambda row: (float(row["j"]) > 0, row["Am"] == "7f8", row["Bm"] == "7f8"),
}


def hard(name, rows):
    """Places of the rows of one family that are taken whatever its size."""
    taken = set()
    for measure in MEASURES[name]:
        taken.update(measure(rows)[:EXTREMES])
    seen = {}
    for place, row in rows:
        outcome = OUTCOMES[name](row)
        seen[outcome] = seen.get(outcome, 0) + 1
        if seen[outcome] <= EXTREMES:
            taken.add(place)
    return taken


def spaced(places, count):
    """So many of them, at equal distances."""
    return {places[index * len(places) // count] for index in range(count)}


def quotas(sizes, count):
    """Parts of count in proportion to the sizes: largest remainders, the first family on a tie."""
    whole = sum(sizes.values())
    parts = {family: count * size // whole for family, size in sizes.items()}
    order = sorted(sizes, key=lambda family: -(count * sizes[family] % whole))
    for family in order[:count - sum(parts.values())]:
        parts[family] += 1
    return parts


def drawn(name, lines):
    """The header and the lines that are taken, unchanged."""
    families = {}
    for place, row in enumerate(csv.DictReader(lines)):
        families.setdefault(row["family"], []).append((place, row))
    taken = set()
    for rows in families.values():
        taken |= hard(name, rows)
    left = {family: [place for place, _ in rows if place not in taken] for family, rows in families.items()}
    parts = quotas({family: len(places) for family, places in left.items()}, ROWS[name] - len(taken))
    for family, places in left.items():
        taken |= spaced(places, parts[family])
    return [lines[0]] + [lines[place + 1] for place in sorted(taken)]


def read_lines(path):
    with open(path, encoding="ascii", newline="") as file:
        return file.read().splitlines(keepends=True)


def main(words):
    check = words[:1] == ["--check"]
    folders = words[1:] if check else words
    if len(folders) != 2:
        print(__doc__)
        return 2
    whole, part = folders
    good = True
    for name in ROWS:
        lines = drawn(name, read_lines(os.path.join(whole, name)))
        path = os.path.join(part, name)
        if check:
            same = read_lines(path) == lines
            print(f"{name}: {'as drawn' if same else 'NOT what would be drawn'}")
            good = good and same
        else:
            with open(path, "w", encoding="ascii", newline="") as file:
                file.writelines(lines)
            print(f"{name}: {len(lines) - 1} rows")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
