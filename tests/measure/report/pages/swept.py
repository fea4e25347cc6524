# SPDX-License-Identifier: MIT
"""Boxes of turning capsules: tightness, leaks and cost against the angle of turn."""

from markdown import number, share, table, times
from plot import Panel, Series, draw

TITLE = "Swept volumes"
FILES = ["swept"]

FORMS = ["exact", "chord and sagitta", "sphere", "end boxes"]
OURS = FORMS[:2]
CASES = [("middle", "none"), ("anywhere", "none"), ("middle", "up to a length"), ("anywhere", "up to a length")]


def _ratio(row):
    return row["ratio_millionths"] / 1e6 / row["motions"] if row["motions"] else None


def _case(center, travel):
    return f"centre of mass {center}, travel {travel}"


def _curve(rows, value):
    points = [(float(row["turn"]), value(row)) for row in rows.rows]
    return sorted((x, y) for x, y in points if y)


def _picture(rows, folder):
    panels = []
    for center, travel in CASES:
        chosen = rows.where(center_of_mass=center, travel=travel)
        series = [Series(form, _curve(chosen.where(form=form), _ratio), look) for look, form in enumerate(FORMS)]
        panels.append(Panel(_case(center, travel), "turn, rad", "volume over what is needed", series))
    leaks = [Series(form, _curve(rows.where(form=form).merged(by=["turn", "form"]), lambda row: row["worst_leak_in_lengths"]), look)
             for look, form in enumerate(FORMS)]
    panels.append(Panel("leaks (what does not leak is not drawn)", "turn, rad", "worst leak over the length", leaks))
    cost = [Series(form, _curve(rows.where(form=form).merged(by=["turn", "form"]), lambda row: row["time_box_in_plain"]),
                   FORMS.index(form)) for form in OURS]
    panels.append(Panel("time of a box over one plain segment distance", "turn, rad", "", cost, logs="x", y_range=(0, None)))
    return draw(folder, "swept", "Boxes of a turning capsule", panels)


HEADER = ["turn, rad", "centre of mass", "travel", "form", "volume over needed, mean", "worst", "motions that leak", "worst leak / length",
          "time, box", "time, 26-DOP"]


def _lines(rows):
    for row in rows.rows:
        yield [number(float(row["turn"]), 3), row["center_of_mass"], row["travel"], row["form"], number(_ratio(row), 3), number(row["worst_ratio"]),
               share(row["leaks"], row["motions"]), number(row["worst_leak_in_lengths"], 3), times(row["time_box_in_plain"]),
               times(row["time_dop26_in_plain"])]


TEXT = """Axis-aligned boxes of capsules 1 m long and 4 cm thick that turn about any axis through their centre of mass, at rest or
travelling by up to a length. *Exact*: `swept_aabb`, which the world's pair filter uses; *chord and sagitta*: `coarse_swept_aabb`;
*sphere*: the box of the paper's swept sphere; *end boxes*: the union of the boxes at both ends of the step, which is not safe. The
first three are computed in float. What is needed comes from 2001 places in double. Times are multiples of one plain
segment-segment distance in double.
"""


def page(tables, folder):
    rows = tables["swept"]
    everything = f"# {TITLE}: all kinds of motion\n\n" + table(HEADER, list(_lines(rows)))
    (folder / "swept_all.md").write_text(everything)
    still = rows.where(travel="none")
    return "".join([TEXT, "\n", _picture(rows, folder), "\nWithout travel (all: [swept_all.md](swept_all.md), data: "
                    "[swept.csv](swept.csv)):\n\n", table(HEADER, list(_lines(still)))])
