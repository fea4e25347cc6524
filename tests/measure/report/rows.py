# SPDX-License-Identifier: MIT
"""Rows of a section's CSV. A column's name says how it merges: `name` is a key, `name:sum` adds, `name:max` and
`name:min` keep the larger and the smaller, `name:hist` adds bins (tests/measure/report/table.hpp)."""

import csv
import math

PARTS_OF_OCTAVE = 32  # as in histogram.hpp
LEAST_EXPONENT = -80


class Hist(dict):
    """Counts by bin; bins as in histogram.hpp."""

    @classmethod
    def parse(cls, text):
        return cls((int(b), int(c)) for b, c in (cell.split(":") for cell in text.split()))

    @staticmethod
    def edge(bin_number):
        if bin_number <= 0:
            return 0.0
        octave, part = divmod(bin_number - 1, PARTS_OF_OCTAVE)
        return math.ldexp(0.5 * (1 + part / PARTS_OF_OCTAVE), octave + LEAST_EXPONENT)

    @property
    def count(self):
        return sum(self.values())

    def quantile(self, share):
        """Lower edge of the bin of rank ceil(share count); None if nothing was counted."""
        rank, seen = math.ceil(share * self.count), 0
        for number in sorted(self):
            seen += self[number]
            if seen >= rank:
                return self.edge(number)
        return None

    def plus(self, other):
        total = Hist(self)
        for number, count in other.items():
            total[number] = total.get(number, 0) + count
        return total

    def text(self):
        return " ".join(f"{number}:{self[number]}" for number in sorted(self))


def _number(text):
    return None if text == "" else float(text)


def _extreme(choose):
    return lambda a, b: choose((x for x in (a, b) if x is not None), default=None)


# How a cell is read and how two are merged, by the kind of the column.
KINDS = {
    "sum": (int, lambda a, b: a + b),
    "max": (_number, _extreme(max)),
    "min": (_number, _extreme(min)),
    "hist": (Hist.parse, Hist.plus),
}


def _text(value):
    if value is None:
        return ""
    if isinstance(value, Hist):
        return value.text()
    return repr(value) if isinstance(value, float) else str(value)


class Rows:
    """A table: `kinds` maps a column to its kind ("" for keys), `rows` are dicts by column."""

    def __init__(self, kinds, rows):
        self.kinds = kinds
        self.rows = rows

    @classmethod
    def read(cls, path):
        with open(path, newline="") as file:
            header, *lines = list(csv.reader(file)) or [[]]
        names = [(name.partition(":")[0], name.partition(":")[2]) for name in header]
        unknown = [kind for _, kind in names if kind and kind not in KINDS]
        if unknown or not names:
            raise ValueError(f"{path}: {'no columns' if not names else 'unknown kind of column: ' + unknown[0]}")
        rows = []
        for number, line in enumerate(lines, 2):
            if len(line) != len(names):
                raise ValueError(f"{path}:{number}: {len(line)} cells, not {len(names)}")
            rows.append({name: KINDS[kind][0](cell) if kind else cell for (name, kind), cell in zip(names, line)})
        return cls(dict(names), rows)

    def write(self, path):
        with open(path, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow([name + (f":{kind}" if kind else "") for name, kind in self.kinds.items()])
            writer.writerows([[_text(row[name]) for name in self.kinds] for row in self.rows])

    def merged(self, by=None):
        """One row for each set of equal keys, in the order of first appearance. `by`: only these keys are kept, the
        rest is merged."""
        keys = [name for name, kind in self.kinds.items() if not kind and (by is None or name in by)]
        kinds = {name: kind for name, kind in self.kinds.items() if kind or name in keys}
        groups = {}
        for row in self.rows:
            key = tuple(row[name] for name in keys)
            groups[key] = _joined(groups.get(key), {name: row[name] for name in kinds}, kinds)
        return Rows(kinds, list(groups.values()))

    def where(self, **values):
        """The rows whose keys have these values."""
        return self.among(**{key: [value] for key, value in values.items()})

    def among(self, **values):
        """The rows whose keys have one of these values."""
        return Rows(self.kinds, [row for row in self.rows if all(row[k] in v for k, v in values.items())])


def _joined(a, b, kinds):
    if a is None:
        return b
    return {name: KINDS[kind][1](a[name], b[name]) if kind else a[name] for name, kind in kinds.items()}


def joined(tables):
    """Tables with the same columns as one, merged."""
    first = tables[0]
    if any(list(table.kinds.items()) != list(first.kinds.items()) for table in tables):
        raise ValueError("the files have different columns")
    return Rows(first.kinds, [row for table in tables for row in table.rows]).merged()
