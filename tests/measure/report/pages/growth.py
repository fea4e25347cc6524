# SPDX-License-Identifier: MIT
"""What a step costs against the number of bodies."""

from markdown import number, table
from plot import Panel, Series, draw
from rows import Rows

TITLE = "Cost against the number of bodies"
FILES = ["growth"]

CROWDS = ["sparse", "dense", "worst"]
MOST_GROWTH = 2.2  # of a sparse crowd, from N to 2 N
PART = "growth_m4f.csv"  # instructions on a part, if they were counted (tests/measure/growth)


def _crowd(rows, crowd):
    return sorted((row for row in rows.where(crowd=crowd).rows if row["steps"]), key=lambda row: int(row["bodies"]))


def _cost(row, share=0.5):
    """Time of a step in us, or thousands of instructions."""
    return row["time_ns"].quantile(share) / 1000 if "time_ns" in row else row["instructions"] / row["steps"] / 1000


def _growths(rows):
    """Cost over that of half as many bodies, by number of bodies."""
    costs = {int(row["bodies"]): _cost(row) for row in rows}
    return {n: costs[n] / costs[n // 2] for n in costs if costs.get(n // 2)}


def _growth_cell(crowd, growth):
    if growth is None:
        return "-"
    return f"{growth:.2f} ×" + (f" **above {MOST_GROWTH}**" if crowd == "sparse" and growth > MOST_GROWTH else "")


def _cells(row, growth):
    per_step = [number(row[name] / row["steps"]) for name in ("pairs", "evaluations", "contacts", "pairs_dropped")]
    tail = f"{_cost(row, 0.99):.1f}" if "time_ns" in row else "-"
    return [row["crowd"], row["bodies"], f"{_cost(row):.2f}", tail, _growth_cell(row["crowd"], growth), *per_step,
            number(row["deepest_overlap_m"]), f"{int(float(row['bytes'])) / 1024:.0f}"]


def _lines(rows):
    for crowd in CROWDS:
        chosen = _crowd(rows, crowd)
        growths = _growths(chosen)
        yield from (_cells(row, growths.get(int(row["bodies"]))) for row in chosen)


def _header(unit, middle):
    return ["crowd", "bodies", f"{unit} a step, {middle}", "99 %", "over half as many", "pairs searched a step",
            "evaluations", "contacts", "pairs without room", "deepest overlap, m", "RAM, KiB"]


def _picture(rows, folder, name, title, unit):
    panels = []
    for what, cost in ((f"{unit} a step", lambda row: _cost(row)), (f"{unit} a step and body",
                                                                    lambda row: _cost(row) / int(row["bodies"]))):
        series = [Series(crowd, [(int(row["bodies"]), cost(row)) for row in _crowd(rows, crowd)], look)
                  for look, crowd in enumerate(CROWDS)]
        panels.append(Panel(what, "bodies", "", series))
    return draw(folder, name, title, panels)


def _verdict(rows):
    growths = _growths(_crowd(rows, "sparse"))
    if not growths:
        return ""
    worst = max(growths, key=growths.get)
    verdict = "within" if growths[worst] <= MOST_GROWTH else "**above**"
    return f"Largest growth of a sparse crowd: {growths[worst]:.2f} × (to {worst} bodies), {verdict} {MOST_GROWTH} ×.\n"


TEXT = """Capsules in flight at up to 1 m/s and 5 rad/s, 1 ms a step, in float; each world has room for just so many
bodies, and for eight pairs for each of them. *Sparse*: half a metre to the next one, capsules 0.24 m long; few meet.
*Dense*: 0.2 m to the next one; each has several neighbours. *Worst*: 2 m long, side by side along the diagonal of space,
so that all boxes overlap: from 18 bodies on there are more pairs than room for them, and their bodies go on
together from where they were proven free, counted, and safe. Times are those of this host alone.
"""


def _part(folder):
    path = folder / PART
    if not path.is_file():
        return f"\n*There is no {PART}: the workflow `target` counts the instructions of a Cortex-M4F.*\n"
    rows = Rows.read(path).merged()
    return "".join(["\n### Instructions on a Cortex-M4F\n\nCounted under QEMU, thousands a step.\n\n", _verdict(rows), "\n",
                    _picture(rows, folder, "growth_m4f", "Thousands of instructions against bodies, Cortex-M4F", "1000 instructions"),
                    "\n", table(_header("1000 instructions", "mean"), list(_lines(rows)))])


def page(tables, folder):
    rows = tables["growth"]
    return "".join([TEXT, "\n", _verdict(rows), "\n", _picture(rows, folder, "growth", "Cost against bodies, this host", "µs"), "\n",
                    table(_header("µs", "median"), list(_lines(rows))), "\nData: [growth.csv](growth.csv).\n", _part(folder)])
