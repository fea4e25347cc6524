#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the README's table of prices against what was measured: price.json of build trees, each a column.
Usage: readme_table.py [--update] SOURCE_FOLDER BUILD_TREE...; without --update the columns of these trees must be in
README.md as measured. Exit code 1: they are not; 77: a tree has no price.json, or one without instructions."""

import json
import pathlib
import re
import sys

from tools import budgets

SKIPPED = 77
BLOCK = re.compile(r"(<!-- begin price -->\n).*?(<!-- end -->)", re.S)
CPUS = ["cortex-m0plus", "cortex-m3", "cortex-m4f", "cortex-m7", "cortex-m33", "cortex-m55"]

# Label, and the figures that stand behind each other in a cell.
ROWS = [
    ("flash, B: detection only", ["detection_only.flash"]),
    ("two capsules with response", ["two_capsules.flash"]),
    ("full duel", ["duel.flash"]),
    ("fencing firmware", ["firmware.flash"]),
    ("RAM, B: two capsules", ["two_capsules.ram"]),
    ("full duel", ["duel.ram"]),
    ("fencing firmware, without its byte buffers", ["firmware.ram_without_buffers"]),
    ("worst-case stack, B: detection only", ["detection_only.stack"]),
    ("two capsules with response", ["two_capsules.stack"]),
    ("full duel", ["duel.stack"]),
    ("fencing firmware, with interrupts", ["firmware.stack"]),
    ("instructions: segment-segment, median / max", ["segment_segment.median", "segment_segment.max"]),
    ("a pair made ready, max", ["make_moving_pair.max"]),
    ("one search evaluation, median / max", ["search.evaluation.median", "search.evaluation.max"]),
    ("search over generic pairs, mean", ["search.generic.mean"]),
    ("of these a hit, median / 99.9 % / max", [f"search.generic.hit.{word}" for word in ("median", "99.9%", "max")]),
    ("of these a miss, median / 99.9 % / max", [f"search.generic.miss.{word}" for word in ("median", "99.9%", "max")]),
    ("worst search, default budget", ["search.worst"]),
    ("impulse with restitution, max", ["impulse.max"]),
    ("duel step, two armed fencers, median / 99.9 % / max", ["duel.step.median", "duel.step.99.9%", "duel.step.max"]),
    ("steps a second at 133 MHz, were an instruction a cycle", ["duel.rate_at_133_MHz"]),
]


def cell(names, lookup):
    """Numbers behind each other; empty where there is none."""
    values = [lookup(name) for name in names]
    return "" if all(value is None for value in values) else " / ".join(budgets.number(value) for value in values)


def price_of(tree):
    """price.json of a build tree; without figures where there is none."""
    found = sorted(tree.rglob("price/price.json"))
    return json.loads(found[0].read_text()) if found else {"figures": {}}


def column_of(tree):
    """(cpu, cells) of a build tree; None where it was not measured in full."""
    price = price_of(tree)
    if "duel.step.max" not in price["figures"]:
        return None
    return price["cpu"], [cell(names, price["figures"].get) for _, names in ROWS]


def limit_columns(limits):
    """Bound and aim of the cpu that has them."""
    none = budgets.Limits(None, None, None)

    def limit(kind):
        return lambda name: getattr(limits.get((budgets.BOUND_CPU, name), none), kind)
    return [[cell(names, limit(kind)) for _, names in ROWS] for kind in ("bound", "aim")]


def read_columns(text):
    """cpu -> cells of the table as it stands in the README."""
    lines = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
    if len(lines) != len(ROWS) + 2:
        return {}
    heads = [head.strip() for head in lines[0]]
    return {head: [line[i].strip() for line in lines[2:]] for i, head in enumerate(heads) if head in CPUS}


def table(columns, limits):
    bound, aim = limit_columns(limits)
    heads, body = ["float, `-O2`"], [[label for label, _ in ROWS]]
    for cpu in CPUS:
        heads.append(cpu)
        body.append(columns.get(cpu, [""] * len(ROWS)))
        if cpu == budgets.BOUND_CPU:
            heads += ["bound", "aim"]
            body += [bound, aim]
    lines = [heads, ["---"] + ["---:"] * (len(heads) - 1), *zip(*body)]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def main():
    words = [word for word in sys.argv[1:] if word != "--update"]
    readme = pathlib.Path(words[0]) / "README.md"
    measured = [column_of(pathlib.Path(word)) for word in words[1:]]
    if not measured or None in measured:
        print("a tree has no prices, or none of instructions: price.py measures them", file=sys.stderr)
        return SKIPPED
    before = readme.read_text()
    block = BLOCK.search(before)
    if not block:
        sys.exit("README.md: there is no '<!-- begin price -->' ... '<!-- end -->'")
    columns = {**read_columns(block.group(0)), **dict(measured)}
    new = table(columns, budgets.read(pathlib.Path(__file__).resolve().parent / "budgets.csv"))
    after = before[:block.start()] + block.group(1) + new + block.group(2) + before[block.end():]
    if "--update" in sys.argv:
        readme.write_text(after)
        return 0
    if after == before:
        return 0
    print("README.md: the table of prices is not what was measured; readme_table.py --update writes it:\n" + new,
          file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
