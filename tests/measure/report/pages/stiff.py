# SPDX-License-Identifier: MIT
"""Stiff pairs: error and energy against mass ratio and step."""

from markdown import number, table
from plot import Panel, Series, draw

TITLE = "Stiff pairs and steps of any length"
FILES = ["stiff_blows", "stiff_steps"]

SCALARS = ["float", "double"]
ALLOWED = 4  # units of rounding, by src/response/impulse.md and friction.md


def _by(rows, scalar, key):
    return sorted(rows.where(scalar=scalar).rows, key=lambda row: float(row[key]))


def _ratio(row):
    return 10.0 ** float(row["decade"])


def _blow_panel(rows, title, value):
    series = [Series(scalar, [(_ratio(row), row[value]) for row in _by(rows, scalar, "decade")], look)
              for look, scalar in enumerate(SCALARS)]
    return Panel(title, "mass of B over mass of A", "", series, logs="x", y_range=(0, ALLOWED))


def _blow_picture(rows, folder):
    panels = [_blow_panel(rows, "gain of energy, 4 allowed", "energy_u"),
              _blow_panel(rows, "momentum, ulp, 4 allowed", "linear_ulp"),
              _blow_panel(rows, "angular momentum, ulp, 4 allowed", "angular_ulp")]
    return draw(folder, "stiff_blows", "Rounding of a contact against the ratio of the masses", panels, columns=3)


BLOW_HEADER = ["mass of B over A", "scalar", "contacts", "not finite", "gain of energy, of the 4 allowed", "the same, over the energy",
               "momentum, ulp", "angular momentum, ulp"]


def _blow_table(rows):
    lines = [[f"1e{row['decade']}", scalar, str(row["contacts"]), str(row["not_finite"]), number(row["energy_u"]),
              number(row["energy_share"]), number(row["linear_ulp"]), number(row["angular_ulp"])]
             for scalar in SCALARS for row in _by(rows, scalar, "decade") if int(row["decade"]) % 3 == 0]
    return table(BLOW_HEADER, lines)


STEP_VALUES = [("place_m", "place of a rod after a second, m"), ("orientation_rad", "its orientation, rad"),
               ("meeting_m", "place of a ball that met another, m")]


def _step_length(row):
    return 1 / float(row["steps_a_second"])


def _step_picture(rows, folder):
    panels = [Panel(title, "step, s", "", [
        Series(scalar, [(_step_length(row), row[value]) for row in _by(rows, scalar, "steps_a_second") if row[value]], look)
        for look, scalar in enumerate(SCALARS)]) for value, title in STEP_VALUES]
    return draw(folder, "stiff_steps", "Error after a second against the length of the step", panels, columns=3)


def _step_table(rows):
    lines = [[f"{_step_length(row):.0e}", scalar, *(number(row[value]) for value, _ in STEP_VALUES)]
             for scalar in SCALARS for row in _by(rows, scalar, "steps_a_second")]
    return table(["step, s", "scalar", *(title for _, title in STEP_VALUES)], lines)


TEXT = """Random contacts of bodies whose moments are up to 1e6 apart, with restitution 0 ... 1 and friction 0 ... 1e6. The gain of energy is in
units of u times the size of the terms that are rounded (src/response/friction.md, which allows 4); that of momentum in ulp of the largest
term of its sum, |p|, |c| |p|, |b| and (|c| + |r|) |J| of either body, before or after: 4 as well.

"""

STEP_TEXT = """
### Steps from a microsecond to a second

A rod that flies and turns, and two equal elastic balls that meet head on, against the closed form. No method error is to be seen: a second
in one step is as good as in a thousand. More steps round more often, and each rounds the place once. A ball that met another is off by
the gap at which the search says *contact*, 1e-6 of the lengths in its query.

"""


def page(tables, folder):
    blows, steps = tables["stiff_blows"], tables["stiff_steps"]
    return "".join([TEXT, _blow_picture(blows, folder), "\n", _blow_table(blows), "\nData: [stiff_blows.csv](stiff_blows.csv)\n",
                    STEP_TEXT, _step_picture(steps, folder), "\n", _step_table(steps), "\nData: [stiff_steps.csv](stiff_steps.csv)\n"])
