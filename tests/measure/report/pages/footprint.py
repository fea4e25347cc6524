# SPDX-License-Identifier: MIT
"""What a scene takes on each part, and what each feature of it costs."""

from markdown import table

TITLE = "Footprint of the scenes"
FILES = ["footprint", "features"]

TEXT = """Each scene linked alone, less an image without one: flash, RAM and the stack below `World::step()` in bytes; instructions of a
step over a run of 200 ms, as QEMU counts them. The trees of the targets measure this (`price.WithinBudgets`); a part that is
not here was not measured. Without an FPU the rack is not run.
"""

FEATURES = """
What a feature costs on a Cortex-M4F: the difference of two scenes that differ in nothing else. *Free step*: the median of the
steps before the first contact of two blades whose boxes overlap; *contact*: the step in which they meet. Negative: what was
chosen takes less than what it is in place of.
"""


def _cell(value, sign=""):
    return "-" if value is None else f"{value:{sign},.0f}"


def _footprint(rows):
    for row in rows.rows:
        times = f"{_cell(row['step_median'])} / {_cell(row['step_max'])}"
        yield [row["scene"], row["cpu"], _cell(row["flash"]), _cell(row["ram"]), _cell(row["stack"]), times]


def _features(rows):
    for row in rows.rows:
        yield [row["feature"], *(_cell(row[name], "+") for name in ("flash", "ram", "stack", "step_free", "step_hit"))]


def page(tables, _folder):
    scenes = table(["scene", "cpu", "flash", "RAM", "stack", "instructions of a step, median / max"],
                   list(_footprint(tables["footprint"])))
    features = table(["feature", "flash", "RAM", "stack", "free step", "contact"], list(_features(tables["features"])))
    return "".join([TEXT, "\n", scenes, FEATURES, "\n", features])
