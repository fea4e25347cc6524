# SPDX-License-Identifier: MIT
"""What the laws of motion come to: curves over time beside Bullet's, and errors against the step."""

from markdown import number, shown, table
from plot import Panel, Series, draw

TITLE = "Motion: energy, momentum and height over time; laws against the step"
FILES = ["motion"]

LEAST_ERROR = 1e-16  # a zero on a logarithmic axis
SCALARS = ["float", "double"]
CURVES = [("bounce", "energy", "elastic ball from 1 m: E / E0"), ("bounce", "height_m", "the same: height, m"),
          ("row", "momentum", "five balls in a row at 25 m/s: p / p0"), ("row", "energy", "the same: E / E0"),
          ("tumble", "energy", "a rod that tumbles freely: E / E0"), ("stack", "height_m", "ten crossed layers: height of the top, m")]


def _engines(rows, what):
    return list(dict.fromkeys(row["who"] for row in rows.where(kind="curve", what=what).rows))


def _curve(rows, what, engine, column):
    chosen = sorted(rows.where(kind="curve", what=what, who=engine).rows, key=lambda row: float(row["at"]))
    scale = 1 if column == "height_m" else chosen[0][column]
    return [(float(row["at"]), row[column] / scale) for row in chosen]


def _panel(rows, what, column, title):
    series = [Series(engine, _curve(rows, what, engine, column), look, marks=False) for look, engine in enumerate(_engines(rows, what))]
    return Panel(title, "s", "", series, logs="")


def _laws(rows):
    return list(dict.fromkeys(row["what"] for row in rows.where(kind="law").rows))


def _law(rows, law, scalar):
    chosen = sorted(rows.where(kind="law", what=law, who=scalar).rows, key=lambda row: float(row["at"]))
    return [(float(row["at"]) / 1000, max(row["error"], LEAST_ERROR)) for row in chosen]


def _law_table(rows):
    steps = [step for step, _ in _law(rows, _laws(rows)[0], "float")]
    return table(["law, scalar", *(f"{step:g} ms" for step in steps)],
                 [[f"{law}, {scalar}"] + [number(error) for _, error in _law(rows, law, scalar)]
                  for law in _laws(rows) for scalar in SCALARS])


def _end_table(rows):
    """Where each curve ends."""
    lines = []
    for what, column, title in CURVES:
        for engine in _engines(rows, what):
            values = [value for _, value in _curve(rows, what, engine, column)]
            lines.append([title, engine, f"{values[0]:.7g}", f"{min(values):.7g}", f"{max(values):.7g}", f"{values[-1]:.7g}"])
    return table(["case", "engine", "start", "least", "most", "end"], lines)


TEXT = """What the laws say is pencil and paper: E / E0 and p / p0 are 1, the ball comes back to 1.05 m, the stack stands. Engines as in the
section on worlds. *Row*: balls that close at 25 mm/s each, C = 0.5: energy falls by what the blows take, momentum does not.

Errors against the step are shares of what a formula says: the parabola after a second; E / E0 of an elastic ball over ten
seconds; g (sin - mu cos) of a rod that slides; g sin / (1 + I / (m r^2)) of one that rolls; E / E0 of a body with moments 1 : 2 : 3
at 10 rad/s over ten seconds. None is taken from the library's own output.
"""


def page(tables, folder):
    rows = tables["motion"]
    curves = draw(folder, "motion", "Motion over time", [_panel(rows, *curve) for curve in CURVES])
    laws = draw(folder, "laws", "Laws of motion: error against the step",
                [Panel(scalar, "step, ms", "", [Series(law, _law(rows, law, scalar), look) for look, law in enumerate(_laws(rows))])
                 for scalar in SCALARS])
    return "".join([TEXT, "\n", curves, "\n", _end_table(rows), "\n", laws, "\n", _law_table(rows), "\nData: [motion.csv](motion.csv).\n"])


def blocks(tables):
    """What docs/error.md shows: the pictures, and the errors of the laws."""
    return {"motion": shown("motion", "Motion over time") + shown("laws", "Laws of motion: error against the step")
                      + _law_table(tables["motion"])}
