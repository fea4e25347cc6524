# SPDX-License-Identifier: MIT
"""The budgets: a file of lines "part,figure,bound,aim,kept". A build must not exceed what was reached before, which is kept, or
where nothing is, the bound, which was promised. What is kept may lie above the bound: then the bound is missed, and every run
says so; the aim is what it wants to reach."""

import collections
import csv
import math

Limits = collections.namedtuple("Limits", "bound aim kept")
Row = collections.namedtuple("Row", "figure value limits is_over")

HEADER = ["part", "figure", "bound", "aim", "kept"]

# The part for which bounds are promised.
BOUND_CPU = "cortex-m4f"

IMAGES = "detection_only", "two_capsules", "duel", "firmware"
# The same with another choice, where bounds are promised: the paper's search, an opponent in place of a stick. What the
# latter takes beyond the firmware is figures of its own.
CHOICES = "duel_stepping", "firmware_opponent"
OF_OPPONENT = "opponent.flash", "opponent.ram", "firmware_opponent.stack"
# Ready-made scenes (include/batuta/world/scenes.hpp), and those of them that are written by hand as well.
SCENES = "StraightSpheres", "DetectionOnly", "TwoBlades", "Rack"
BY_HAND = SCENES[:3]


def each(names, *kinds):
    return [f"{name}.{kind}" for name in names for kind in kinds]


# Figures of which is kept what was reached, by part: everything where bounds are promised; elsewhere what would show a
# loss that this part alone has. Parts that are not named are measured and shown.
WITH_FPU = [*each(IMAGES + SCENES, "flash", "stack"), "duel.step.99.9%"]
KEPT = {
    BOUND_CPU: [*each(IMAGES + ("duel_stepping",) + SCENES, "flash", "ram", "stack"), *each(SCENES, "step.median", "step.max"),
                *each(BY_HAND, "flash_of_by_hand"), "segment_segment.median", "segment_segment.max", "search.evaluation.median",
                "search.generic.mean", "search.worst", "impulse.max", *each(("duel.step",), "median", "99.9%", "max"),
                "duel.step.cycles.99.9%", "duel.step.cycles.max", "duel_stepping.step.99.9%",
                *OF_OPPONENT, "opponent.step.99.9%"],
    "cortex-m7": WITH_FPU, "cortex-m33": WITH_FPU, "cortex-m55": WITH_FPU,
    "stm32f405": [*each(("firmware", "usb_stick"), "flash", "ram", "stack"), *OF_OPPONENT],
    "cortex-m0plus": each(("usb_stick",), "flash", "ram", "stack"),
}

# What is kept of what was reached: so much more may come with a new compiler or a small change.
ROOM = 1.02
# How an opponent decides is still being fenced out.
ROOM_OF_OPPONENTS = 1.15


def read(path):
    """(part, figure) -> Limits, in the order of the file."""
    found = {}
    with path.open(newline="") as file:
        for entry in csv.DictReader(line for line in file if not line.startswith("#")):
            key = entry["part"], entry["figure"]
            if key in found:
                raise ValueError(f"{path.name}: {', '.join(key)}: stated twice")
            found[key] = Limits(*(float(entry[name]) if entry[name] else None for name in HEADER[2:]))
    return found


def most(limits):
    """What a figure must not exceed, or None."""
    return limits.bound if limits.kept is None else limits.kept


def room_of(figure):
    return ROOM_OF_OPPONENTS if "opponent" in figure else ROOM


def kept_of(value, bound, room=ROOM):
    """What is kept of a value that was reached: with room, but not beyond a bound that it meets."""
    room = float(math.ceil(room * value))
    return min(room, bound) if bound is not None and value <= bound else room


def compare(limits, part, figures):
    """A Row for each figure, in their order; a limit without a figure is exceeded, for nobody looked."""
    left = {figure: of for (of_part, figure), of in limits.items() if of_part == part}
    rows = []
    for figure, value in figures.items():
        of = left.pop(figure, Limits(None, None, None))
        rows.append(Row(figure, value, of, most(of) is not None and value > most(of)))
    return rows + [Row(figure, None, of, most(of) is not None) for figure, of in left.items()]


def kept_figures(part):
    return KEPT.get(part, [])


def keep(path, part, figures, names):
    """Writes what was reached now as what is kept of these figures."""
    comments = [line for line in path.read_text().splitlines() if line.startswith("#")]
    limits = read(path)
    for figure in names:
        if figure in figures:
            before = limits.get((part, figure), Limits(None, None, None))
            limits[part, figure] = before._replace(kept=kept_of(figures[figure], before.bound, room_of(figure)))
    lines = [",".join([*key, *("" if limit is None else f"{limit:.0f}" for limit in of)]) for key, of in limits.items()]
    path.write_text("\n".join([*comments, ",".join(HEADER), *lines]) + "\n")


def number(value):
    return "-" if value is None else f"{value:,.0f}"


def mark(row):
    if row.value is None:
        return "  NOT MEASURED" if row.is_over else ""
    if row.is_over:
        return "  OVER"
    if row.limits.bound is not None and row.value > row.limits.bound:
        return "  MISSES ITS BOUND"
    return "  misses its aim" if row.limits.aim is not None and row.value > row.limits.aim else ""


def table(rows):
    """Text for the console."""
    lines = [f"{'':40}{'measured':>12}{'bound':>10}{'aim':>10}{'kept':>10}"]
    for row in rows:
        limits = "".join(f"{number(limit):>10}" for limit in row.limits)
        lines.append(f"{row.figure:40}{number(row.value):>12}{limits}{mark(row)}")
    return "\n".join(lines)
