#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the tables of prices of docs/cost.md against what was measured: price.json of build trees, each a column; the table of
features is that of the part for which bounds are promised.
Usage: readme_table.py [--update] SOURCE_FOLDER BUILD_TREE...; without --update the columns of these trees must be in
docs/cost.md as measured. Exit code 1: they are not; 77: a tree has no price.json, or one without instructions."""

import json
import pathlib
import re
import sys

from tools import budgets, scenes

SKIPPED = 77
PAGE = "docs/cost.md"
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
    ("the same in cycles, from above", ["duel.step.cycles.median", "duel.step.cycles.99.9%", "duel.step.cycles.max"]),
    ("steps a second at 133 MHz, were an instruction a cycle", ["duel.rate_at_133_MHz"]),
]

READY_MADE = [("spheres in straight flight", "StraightSpheres"), ("detection only", "DetectionOnly"),
              ("two blades", "TwoBlades"), ("rack of 64 capsules", "Rack")]


def scene_rows(kind, names):
    """Rows of one kind of figure, the first of which says the kind."""
    for i, (label, scene) in enumerate(READY_MADE):
        yield (f"{kind}: {label}" if i == 0 else label), [f"{scene}.{name}" for name in names]


SCENE_ROWS = [
    *scene_rows("flash, B", ["flash"]), ("duel", ["Duel.flash"]),
    *scene_rows("RAM, B", ["ram"]), ("duel", ["Duel.ram"]),
    *scene_rows("worst-case stack of a step, B", ["stack"]),
    *scene_rows("instructions of a step, median / max", ["step.median", "step.max"]),
    *list(scene_rows("flash, % of the same scene by hand", ["flash_of_by_hand"]))[:len(budgets.BY_HAND)],
]
# Of a duel with other choices: label, image, figures of a step.
CHOICE_HEADS = ["on a Cortex-M4F", "flash, B", "RAM, B", "worst-case stack, B", "instructions of a step, median / 99.9 % / max"]
CHOICES = [
    ("full duel, certified search", "duel", "duel.compared"),
    ("the same by the paper's stepping and bisection", "duel_stepping", "duel_stepping"),
    ("fencing firmware", "firmware", None),
    ("the same with an opponent in place of a stick", "firmware_opponent", None),
    ("of that the opponent", "opponent", "opponent"),
]
SIZES = "flash", "ram", "stack"
TABLES = {"price": ROWS, "scenes": SCENE_ROWS}


def cell(names, lookup):
    """Numbers behind each other; empty where there is none."""
    values = [lookup(name) for name in names]
    return "" if all(value is None for value in values) else " / ".join(budgets.number(value) for value in values)


def price_of(tree):
    """price.json of a build tree; without figures where there is none."""
    found = sorted(tree.rglob("price/price.json"))
    return json.loads(found[0].read_text()) if found else {"figures": {}}


def column_of(price, rows):
    """(cpu, cells) of a part."""
    return price["cpu"], [cell(names, price["figures"].get) for _, names in rows]


def limit_columns(limits, rows):
    """Bound and aim of the cpu that has them."""
    none = budgets.Limits(None, None, None)

    def limit(kind):
        return lambda name: getattr(limits.get((budgets.BOUND_CPU, name), none), kind)
    return [[cell(names, limit(kind)) for _, names in rows] for kind in ("bound", "aim")]


def read_columns(text, rows):
    """cpu -> cells of a table as it stands in the page."""
    lines = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
    if len(lines) != len(rows) + 2:
        return {}
    heads = [head.strip() for head in lines[0]]
    return {head: [line[i].strip() for line in lines[2:]] for i, head in enumerate(heads) if head in CPUS}


def table(columns, limits, rows):
    bound, aim = limit_columns(limits, rows)
    heads, body = ["float, `-Os`"], [[label for label, _ in rows]]
    for cpu in CPUS:
        heads.append(cpu)
        body.append(columns.get(cpu, [""] * len(rows)))
        if cpu == budgets.BOUND_CPU:
            heads += ["bound", "aim"]
            body += [bound, aim]
    return markdown(heads, zip(*body))


def markdown(heads, lines):
    """Text in the first column, numbers in the others."""
    lines = [heads, ["---"] + ["---:"] * (len(heads) - 1), *lines]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def feature_table(figures):
    heads = ["what a feature costs", "flash, B", "RAM, B", "stack, B", "instructions of a free step", "of one with a contact"]
    return markdown(heads, [[feature.label, *(f"{costs[kind]:+,}" if kind in costs else "" for kind in scenes.FIGURES)]
                            for feature, costs in scenes.prices(figures)])


def choice_table(figures):
    spreads = "median", "99.9%", "max"
    lines = [[label, *(cell([f"{image}.{size}"], figures.get) for size in SIZES),
              cell([f"{step}.step.{word}" for word in spreads], figures.get) if step else ""] for label, image, step in CHOICES]
    return markdown(CHOICE_HEADS, lines)


def filled(text, mark, content_of):
    """The text with a block written anew. @param content_of  of the block as it is, what it is to be"""
    block = re.search(rf"(<!-- begin {mark} -->\n)(.*?)(<!-- end -->)", text, re.S)
    if not block:
        sys.exit(f"{PAGE}: there is no '<!-- begin {mark} -->' ... '<!-- end -->'")
    return text[:block.start(2)] + content_of(block.group(2)) + text[block.end(2):]


def renewed(text, prices):
    """The page with what these parts were measured at."""
    limits = budgets.read(pathlib.Path(__file__).resolve().parent / "budgets.csv")
    for mark, rows in TABLES.items():
        measured = dict(column_of(price, rows) for price in prices)
        text = filled(text, mark, lambda old, r=rows, m=measured: table({**read_columns(old, r), **m}, limits, r))
    for price in prices:
        # Where features were not measured, the table stays as it is.
        if price["cpu"] == budgets.BOUND_CPU and any(scenes.prices(price["figures"])):
            text = filled(text, "features", lambda _, p=price: feature_table(p["figures"]))
        if "duel_stepping.flash" in price["figures"]:
            text = filled(text, "choices", lambda _, p=price: choice_table(p["figures"]))
    return text


def main():
    words = [word for word in sys.argv[1:] if word != "--update"]
    page = pathlib.Path(words[0]) / PAGE
    prices = [price_of(pathlib.Path(word)) for word in words[1:]]
    if not prices or any("duel.step.max" not in price["figures"] for price in prices):
        print("a tree has no prices, or none of instructions: price.py measures them", file=sys.stderr)
        return SKIPPED
    before = page.read_text()
    after = renewed(before, prices)
    if "--update" in sys.argv:
        page.write_text(after)
        return 0
    if after == before:
        return 0
    print(f"{PAGE}: the tables of prices are not what was measured; readme_table.py --update writes them", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
