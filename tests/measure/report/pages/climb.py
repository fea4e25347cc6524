# SPDX-License-Identifier: MIT
"""The most that a search costs: queries found by hill climbing, and near misses."""

import math

from markdown import number, table
from plot import Panel, Series, draw

TITLE = "Worst cases of the certified search"
FILES = ["climb"]


def _mean(row):
    return row["evaluations_sum"] / row["queries"] if row["queries"] else None


def _distance(row):
    return float(row["setting"])


def _climbs(rows):
    header = ["start", "turn, degrees", "climbs", "searches", "worst: evaluations", "median of the climbs"]
    return table(header, [[row["start"], number(_distance(row)), str(row["queries"]), str(row["searches"]), number(row["worst"]),
                           number(row["evaluations"].quantile(0.5))] for row in rows.where(kind="climb").rows])


def _grazes(rows):
    header = ["least gap / S", "queries", "evaluations, mean", "99 %", "worst"]
    return table(header, [[number(_distance(row)), str(row["queries"]), number(_mean(row)),
                           number(row["evaluations"].quantile(0.99)), number(row["worst"])] for row in rows.rows])


def _picture(rows, folder):
    misses = sorted((row for row in rows.rows if _distance(row) > 0), key=_distance)
    values = [("mean", _mean), ("99 %", lambda row: row["evaluations"].quantile(0.99)), ("worst", lambda row: row["worst"])]
    series = [Series(label, [(_distance(row), value(row)) for row in misses], look)
              for look, (label, value) in enumerate(values)]
    most = max((y for line in series for _, y in line.points), default=1)
    panel = Panel("", "distance of the miss / S", "distance evaluations", series, logs="x", y_range=(0, most + 1))
    return draw(folder, "climb", "Cost of a near miss, generic queries, double", [panel])


def _per_decade(rows):
    """Slope of the mean over the decades of the distance, a line fitted through the misses."""
    points = [(-math.log10(_distance(row)), _mean(row)) for row in rows.rows if _distance(row) > 0 and row["queries"]]
    x_mean = sum(x for x, _ in points) / len(points)
    y_mean = sum(y for _, y in points) / len(points)
    return sum((x - x_mean) * (y - y_mean) for x, y in points) / sum((x - x_mean) ** 2 for x, _ in points)


def page(tables, folder):
    rows = tables["climb"]
    grazes = rows.where(kind="graze")
    return "".join([
        "Queries are changed a little at a time, and a change is kept unless the search gets cheaper: what is left is about the most\n"
        "that it costs (a gap of 1e-6 m counts as contact, bodies are about a metre long, double). *generic*: from random queries.\n"
        "*sliding*: an axis goes round another at a gap that hardly changes, as sliding blades do, which takes many steps to prove; what\n"
        "the default budget does not suffice for ends as kBudget, which is safe. The worst are kept as tests\n"
        "(`tests/vectors/worst_queries.csv`).\n\n",
        _climbs(rows), "\nMisses that come nearer and nearer cost ", number(_per_decade(grazes)),
        " evaluations more for each decade.\n\n", _picture(grazes, folder), "\n", _grazes(grazes),
        "\nData: [climb.csv](climb.csv).\n"])
