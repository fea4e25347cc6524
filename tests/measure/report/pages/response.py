# SPDX-License-Identifier: MIT
"""Separation distance against penetration, jitter and cost; bodies at rest; keyframe grids against their size."""

import math

from fit import slope
from markdown import number, percent, share, table, times
from plot import Panel, Series, draw

TITLE = "Separation distance, bodies at rest, and keyframe grids"
FILES = ["separation", "resting", "keyframes"]

PLAYS = ["rest", "slide", "bridge", "press"]
SEARCHES = ["advancement", "stepping"]
TRUTHS = ["arm", "wide"]
DEFAULT_DISTANCE = 1e-4  # D of WorldSettings, m
STEP_NS = 1000000  # of the world, 1 ms
LEAST_KEYS_FOR_SLOPE = 6  # below, the grid is too coarse for its order to show


def _mean_square(hist):
    """Mean of the values, and of their squares, from the middles of the bins."""
    middles = [((hist.edge(b) + hist.edge(b + 1)) / 2 if b > 0 else 0.0, n) for b, n in hist.items()]
    return (sum(x * n for x, n in middles) / hist.count, sum(x * x * n for x, n in middles) / hist.count)


def _jitter(row):
    """Root of the mean square of the gap about its mean, over D."""
    mean, square = _mean_square(row["gap_m"])
    return math.sqrt(max(square - mean * mean, 0)) / float(row["distance"])


def _slide(row):
    """How far a body slid, over how far it would have slid alone; None where nothing slides."""
    return row["travel_nm"] / row["free_travel_nm"] if row["free_travel_nm"] else None


def _slide_error(row):
    return None if _slide(row) is None else abs(_slide(row) - 1)


def _per_step(name):
    return lambda row: row[name] / row["steps"]


def _gap(row):
    return row["gap_m"].quantile(0.5) / float(row["distance"])


# Title, value of a row.
SEPARATION_PANELS = [
    ("median gap over D", _gap),
    ("jitter: rms of the gap about its mean, over D", _jitter),
    ("separations per step", _per_step("separations")),
    ("error of the slide, share", _slide_error),
    ("distance evaluations per step", _per_step("evaluations")),
    ("time per step over one plain segment distance", lambda row: row["time_step_in_plain"]),
]


def _curve(rows, value):
    points = [(float(row["distance"]), value(row)) for row in rows.rows if row["steps"]]
    return sorted((x, y) for x, y in points if y is not None and y > 0)


def _separation_picture(rows, folder, scalar):
    panels = []
    for title, value in SEPARATION_PANELS:
        series = [Series(f"{play}, {search}", _curve(rows.where(scalar=scalar, play=play, search=search), value), look,
                         dashed=search != SEARCHES[0])
                  for look, play in enumerate(PLAYS) for search in SEARCHES]
        panels.append(Panel(title, "D over the length of a capsule", "", series, x_range=(1e-6, 1e-2)))
    return draw(folder, f"response_separation_{scalar}", f"Separation distance D, {scalar}", panels, columns=3)


SEPARATION_HEADER = ["play", "search", "scalar", "D / length", "deepest overlap / D", "overlapping, share", "gap / D, median",
                     "jitter / D", "separations per step", "at most", "longest hold, of the step", "blows per step",
                     "contacts begun anew", "slide, of the free one", "evaluations per step", "at most",
                     "steps in which something did not fit", "time"]


def _separation_cells(row):
    steps = row["steps"]
    return [row["play"], row["search"], row["scalar"], row["distance"],
            number(row["penetration_m"] / float(row["distance"])), share(row["overlaps"], row["samples"]),
            number(_gap(row)), number(_jitter(row)), number(row["separations"] / steps), number(row["most_separations"]),
            percent(row["held_ns"] / (steps * STEP_NS), 3), number(row["collisions"] / steps), str(row["begins"]),
            percent(_slide(row), 3), number(row["evaluations"] / steps), number(row["most_evaluations"]),
            share(row["incomplete"], steps), times(row["time_step_in_plain"])]


def _separation_table(rows, only_default):
    chosen = [row for row in rows.rows
              if row["steps"] and (not only_default or float(row["distance"]) == DEFAULT_DISTANCE)]
    return table(SEPARATION_HEADER, [_separation_cells(row) for row in chosen])


# Title, value of a row of resting.csv.
RESTING_PANELS = [
    ("jitter: lowest to highest, m", lambda row: row["jitter_m"]),
    ("drift sideways in 4 s, m", lambda row: row["drift_m"]),
    ("distance evaluations per simulated second", lambda row: 1000 * row["evaluations"] / row["steps"]),
    ("time per step over one plain segment distance", lambda row: row["time_step_in_plain"]),
]
PILES = ["across", "groove"]
SETTLING = "settling"


def _resting_series(rows, value, scalar):
    """Settling against D; what knows no D as a level line."""
    ends = (1e-6, 1e-2)
    methods = list(dict.fromkeys(row["method"] for row in rows.rows))
    for pile_number, pile in enumerate(PILES):
        for number, method in enumerate(methods):
            chosen = rows.where(scalar=scalar, pile=pile, method=method)
            points = _curve(chosen, value)
            if method != SETTLING:
                points = [(x, y) for _, y in points[:1] for x in ends]
            yield Series(f"{method}, {pile}", points, 2 * number + pile_number, dashed=method != SETTLING,
                         marks=method == SETTLING)


def _resting_picture(rows, folder, scalar):
    panels = [Panel(title, "D, m", "", list(_resting_series(rows, value, scalar)), x_range=(1e-6, 1e-2))
              for title, value in RESTING_PANELS]
    return draw(folder, f"response_resting_{scalar}", f"A rod at rest on two posts, {scalar}", panels)


RESTING_HEADER = ["method", "rod", "scalar", "D, m", "off its posts", "deepest overlap, m", "least gap, m", "jitter, m", "drift in 4 s, m",
                  "answers per step", "frozen per step", "evaluations per simulated second", "at most in a step",
                  "steps in which something did not fit", "time"]


def _resting_cells(row):
    steps = row["steps"]
    distance = row["distance"] if row["method"] == SETTLING else "-"
    if not steps:
        return [row["method"], row["pile"], row["scalar"], distance, str(row["left"])] + ["-"] * (len(RESTING_HEADER) - 5)
    return [row["method"], row["pile"], row["scalar"], distance, str(row["left"]), number(row["penetration_m"]), number(row["least_gap_m"]),
            number(row["jitter_m"]), number(row["drift_m"]), number(row["answers"] / steps), number(row["frozen"] / steps),
            number(1000 * row["evaluations"] / steps), number(row["most_evaluations"]),
            share(row["incomplete"], steps), times(row["time_step_in_plain"])]


def _resting_table(rows):
    return table(RESTING_HEADER, [_resting_cells(row) for row in rows.rows if row["steps"] or row["left"]])


def _errors(rows, name):
    """(cells per axis, value)."""
    return sorted((int(row["keys"]) - 1, row[name]) for row in rows.rows if row[name])


ERRORS = [("place of the hand, m", "worst_place_m"), ("turn, rad", "worst_turn_rad"),
          ("tip of a 0.9 m blade, m", "worst_tip_m")]
JUMPS = ["jump_place_m", "jump_turn_rad", "jump_rate"]


def _third_order(curve):
    """A line of slope -3 through the last point of a curve."""
    cells, error = curve[-1]
    return [(n, error * (cells / n) ** 3) for n, _ in curve]


def _keyframe_picture(rows, folder):
    panels = []
    for title, name in ERRORS:
        series = [Series(f"{truth}, {scalar}", _errors(rows.where(truth=truth, scalar=scalar), name), look,
                         dashed=scalar == "float")
                  for look, truth in enumerate(TRUTHS) for scalar in ("double", "float")]
        series.append(Series("third order", _third_order(series[0].points), 6, marks=False))
        panels.append(Panel(f"largest error: {title}", "cells along a coordinate", "", series, x_range=(1, 16)))
    cost = [Series(f"{truth}, {scalar}", _errors(rows.where(truth=truth, scalar=scalar), "time_in_plain"), look,
                   dashed=scalar == "float")
            for look, truth in enumerate(TRUTHS) for scalar in ("double", "float")]
    panels.append(Panel("time of a pose over one plain segment distance", "cells along a coordinate", "", cost, logs="x",
                        x_range=(1, 16), y_range=(0, None)))
    return draw(folder, "response_keyframes", "Keyframe grids", panels)


def _slope_lines(rows):
    for truth in TRUTHS:
        chosen = rows.where(truth=truth, scalar="double")
        fine = [[(n, e) for n, e in _errors(chosen, name) if n + 1 >= LEAST_KEYS_FOR_SLOPE] for _, name in ERRORS]
        yield [truth] + [number(slope(points)) for points in fine]


def _jump_lines(rows):
    """The largest jumps of all grids."""
    for row in rows.where(truth="wide").merged(by=["scalar"]).rows:
        yield [row["scalar"], str(row["borders"])] + [number(row[name]) for name in JUMPS]


def _keyframe_lines(rows):
    for row in rows.where(scalar="float").rows:
        tip = row["tip_m"]
        yield [row["truth"], row["keys"]] + [number(row[name], 4) for _, name in ERRORS] + [
            number(tip.quantile(0.5), 4), number(tip.quantile(0.99), 4), times(row["time_in_plain"])]


KEYFRAME_HEADER = ["truth", "keys per axis", "place, largest", "turn, largest", "tip, largest", "tip, median", "tip, 99 %",
                   "time"]

SEPARATION_TEXT = """### Separation distance D

Resting contacts are pushed apart to D and go on together for f(D) (src/response/separation.md). Capsules 1 m long and 1 cm thick are stepped
by 1 ms; what is drawn is seen after half a second. *Rest*, *slide*: a rod under its weight across one post, lying or sliding
along it. *Bridge*: a rod that slides along two posts, three bodies, which the paper leaves out. *Press*: two hands press
crossed blades together and draw them along each other. A resting contact keeps its momentum, so weight adds up until the
contact counts as a blow (0.05 m/s here). The two go on as one body, so D costs slide along the contact too; a hand makes up for
it, and where that takes most of a step it overshoots. Times are multiples of one plain segment-segment distance in double.
In float, D is raised to what rounding allows (src/world/detail/margin.md); contacts that end and begin anew tell that it was.
"""

RESTING_TEXT = """
### Bodies at rest

A rod, 1.02 m long and 2 cm thick, lies under its weight on two posts, across them or in the groove between them, with friction 0.5,
and is stepped by 1 ms. *Settling* (`RestingContact::kSettling`): what is left of an approach is taken out without restitution
and the gap is kept near D / 2. *Micro-collisions*, the alternative that the paper names (Mirtich and Canny): the same world with
`RestingContact::kNone`, every contact an impulse, with restitution 0 and 0.5. A settled rod falls through D again and again: D is
its jitter and most of its drift, and the longer fall saves searches. Below what a body falls in a step or two (0.02 mm) a
smaller D brings nothing, and micro-collisions are as good for a single rod. A D of half the rod's thickness lifts it out of the groove:
such a rod is not at rest, so it is counted (*off its posts*), and has no point in the pictures.
"""

KEYFRAME_TEXT = """
### Keyframe grids

A grid of n x n keys samples a smooth hand that is known everywhere: *arm* turns by up to 0.8 rad, *wide* by up to 1.7.
Between the keys the error falls with the third power of the cell (src/control/keyframes.md); two keys per axis give a bilinear
surface. Slopes are fitted from 6 keys on, in double. Pose and velocity are continuous: across borders of cells, from a few
roundings on one side to a few on the other, they jump by rounding.
"""


def page(tables, folder):
    separation, resting, keyframes = tables["separation"], tables["resting"], tables["keyframes"]
    everything = f"# {TITLE}: all distances\n\n{_separation_table(separation, only_default=False)}"
    (folder / "response_all.md").write_text(everything)
    parts = [SEPARATION_TEXT, "\n"]
    parts += [_separation_picture(separation, folder, scalar) + "\n" for scalar in ("float", "double")]
    parts += [f"At D = {DEFAULT_DISTANCE} (all: [response_all.md](response_all.md), data: [separation.csv](separation.csv)):\n\n"]
    parts += [_separation_table(separation, only_default=True), RESTING_TEXT, "\n"]
    parts += [_resting_picture(resting, folder, scalar) + "\n" for scalar in ("float", "double")]
    parts += ["Data: [resting.csv](resting.csv)\n\n", _resting_table(resting), KEYFRAME_TEXT, "\n"]
    parts += [_keyframe_picture(keyframes, folder), "\n"]
    parts += [table(["slope of the largest error", "place", "turn", "tip"], list(_slope_lines(keyframes))), "\n"]
    parts += [table(["largest jump, wide", "borders looked at", "place, m", "turn, rad", "velocity per unit of stick"],
                    list(_jump_lines(keyframes))), "\n"]
    parts += ["Float (data: [keyframes.csv](keyframes.csv)):\n\n", table(KEYFRAME_HEADER, list(_keyframe_lines(keyframes)))]
    return "".join(parts)
