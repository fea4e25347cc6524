# SPDX-License-Identifier: MIT
"""The footprint of the scenes for the report: CSV as tests/measure/report/rows.py reads it, from price.json of every target's tree
that was measured."""

import csv
import json

from . import budgets, scenes

# Scene of the table, and where its figures of stack and time are.
SCENES = [*((name, name) for name in budgets.SCENES), ("Duel", "duel")]
KINDS = "flash", "ram", "stack", "step.median", "step.max"


def _column(kind):
    return kind.replace(".", "_") + ":max"


def lines_of(price):
    """(scene, cpu, a figure for each kind) of a part."""
    figures = price["figures"]
    for scene, other in SCENES:
        cells = [figures.get(f"{scene}.{kind}", figures.get(f"{other}.{kind}")) for kind in KINDS]
        if f"{scene}.flash" in figures:
            yield [scene, price["cpu"], *("" if cell is None else cell for cell in cells)]


def feature_lines(figures):
    for feature, costs in scenes.prices(figures):
        yield [feature.label, int(feature.is_alternative), *(costs.get(kind, "") for kind in scenes.FIGURES)]


def _write(path, header, lines):
    with path.open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *lines])


def write(build):
    """Writes report/footprint.csv and report/features.csv of a build folder."""
    prices = [json.loads(path.read_text()) for path in sorted(build.glob("target/*/tests/measure/price/price.json"))]
    prices = [price for price in prices if price["part"] == price["cpu"]]
    folder = build / "report"
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder / "footprint.csv", ["scene", "cpu", *map(_column, KINDS)],
           [line for price in prices for line in lines_of(price)])
    of_bounds = [price["figures"] for price in prices if price["cpu"] == budgets.BOUND_CPU]
    _write(folder / "features.csv", ["feature", "alternative", *map(_column, scenes.FIGURES)],
           [line for figures in of_bounds for line in feature_lines(figures)])
