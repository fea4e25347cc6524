# SPDX-License-Identifier: MIT
"""Error of the time of contact against cost, for every search and setting."""

import math

from markdown import number, share, shown, table, times
from plot import Panel, Series, draw

TITLE = "Searches: error against cost"
FILES = ["search"]

# Label, method, swept setting; the place gives the look.
CURVES = [
    ("advancement, contact tolerance", "advancement", "contact tolerance"),
    ("stepping, epsilon", "stepping", "epsilon"),
    ("stepping, halvings", "stepping", "halvings"),
    ("regula falsi, iterations", "regula-falsi", "iterations"),
    ("Illinois, iterations", "illinois", "iterations"),
    ("translation, contact tolerance", "translation", "contact tolerance"),
    ("conservative advancement, contact tolerance", "conservative", "contact tolerance"),
]
STILL = ["translation", "sphere"]  # families in which nothing turns
# What the tables show of each method: its default setting.
DEFAULTS = [
    ("advancement", "contact tolerance", 1e-6),
    ("translation", "contact tolerance", 1e-6),
    ("stepping", "halvings", 24),
    ("conservative", "contact tolerance", 1e-6),
    ("regula-falsi", "iterations", 8),
    ("illinois", "iterations", 8),
]
PICTURE = "error_against_cost"  # of the README
LEAST_ERROR = 1e-17  # a zero on a logarithmic axis


def _families(rows):
    return list(dict.fromkeys(row["family"] for row in rows.rows))


def _points(rows, x, y):
    """Curve over the settings, without those in which there was nothing to see."""
    ordered = sorted(rows.rows, key=lambda row: float(row["setting"]))
    pairs = [(x(row), y(row)) for row in ordered]
    return [(a, max(b, LEAST_ERROR)) for a, b in pairs if a and b is not None]


def _evaluations(row):
    return _mean(row, "evaluations")


def _mean(row, group):
    """Mean of a group of distance evaluations."""
    return row[f"{group}_sum"] / row[group].count if row[group].count else None


def _time(row):
    return row["time_whole_ratio"].quantile(0.5)


def _median(row):
    return row["error_free"].quantile(0.5)


def _p99(row):
    return row["error_free"].quantile(0.99)


def _curves(rows, x, y):
    merged = rows.merged(by=["method", "swept", "setting"])
    return [Series(label, _points(merged.where(method=method, swept=swept), x, y), look)
            for look, (label, method, swept) in enumerate(CURVES)]


def _turning(rows):
    return rows.among(family=[family for family in _families(rows) if family not in STILL])


def _main_picture(rows, folder, scalar):
    turning = _turning(rows.where(scalar=scalar))
    error = "error, in steps, of t_{free}"
    panels = [
        Panel("median", "distance evaluations, mean", error, _curves(turning, _evaluations, _median)),
        Panel("99 %", "distance evaluations, mean", error, _curves(turning, _evaluations, _p99)),
        Panel("median", "time over one plain segment distance, median", error, _curves(turning, _time, _median)),
        Panel("99 %", "time over one plain segment distance, median", error, _curves(turning, _time, _p99)),
    ]
    return draw(folder, f"search_{scalar}", f"Error against cost, all families that turn, {scalar}", panels)


def _both_picture(rows, folder):
    """The picture of the README: both scalars side by side, on the same axes."""
    panels = []
    for title, x in (("distance evaluations, mean", _evaluations),
                           ("time over one plain segment distance, median", _time)):
        curves = {scalar: _curves(_turning(rows.where(scalar=scalar)), x, _p99) for scalar in ("float", "double")}
        values = [[point[axis] for series in curves.values() for one in series for point in one.points] for axis in (0, 1)]
        if not values[0]:
            continue
        spans = [(10 ** math.floor(math.log10(min(v))), 10 ** math.ceil(math.log10(max(v)))) for v in values]
        panels += [Panel(scalar, title, "99 % error, in steps, of t_{free}", curves[scalar], x_range=spans[0], y_range=spans[1])
                   for scalar in curves]
    return draw(folder, PICTURE, "Error of the time of contact against cost, all families that turn", panels)


def _family_picture(rows, folder, scalar):
    panels = [Panel(family.replace("_", " "), "distance evaluations, mean", "99 % error, in steps, of t_{free}",
                    _curves(rows.where(scalar=scalar, family=family), _evaluations, _p99))
              for family in _families(rows)]
    return draw(folder, f"search_families_{scalar}", f"Error against cost by family, {scalar}", panels, columns=3)


def _exceeding(hist):
    """(n, share of queries that took n evaluations or more)."""
    left, points = hist.count, []
    for bin_number in sorted(hist):
        points.append((max(hist.edge(bin_number), 0.5), left / hist.count))
        left -= hist[bin_number]
    return points


def _evaluation_picture(rows, folder):
    panels = []
    for scalar in ("double", "float"):
        merged = _turning(rows.where(scalar=scalar)).merged(by=["method", "swept", "setting"])
        found = dict(_default_rows(merged))
        series = [Series(name, _exceeding(found[name]["evaluations"]), look, marks=False)
                  for name, look in (("advancement", 0), ("stepping", 1), ("conservative", 6)) if name in found]
        panels.append(Panel(scalar, "distance evaluations n", "share of queries that take n or more", series))
    return draw(folder, "search_evaluations", "Distance evaluations at the default settings, families that turn", panels)


def _budget_picture(rows, folder):
    panels = []
    for scalar in ("double", "float"):
        budget = rows.where(scalar=scalar, method="advancement", swept="budget")
        series = []
        for look, family in enumerate(_families(budget)):
            points = [(float(row["setting"]), row["said_budget"] / row["queries"])
                      for row in budget.where(family=family).rows if row["said_budget"]]
            series.append(Series(family.replace("_", " "), sorted(points), look, dashed=look >= 8))
        panels.append(Panel(scalar, "budget", "share of queries that end with kBudget", series))
    return draw(folder, "search_budget", "What a budget leaves open (a share of zero is not drawn)", panels)


def _default_rows(rows):
    for method, swept, setting in DEFAULTS:
        for row in rows.where(method=method, swept=swept).rows:
            if float(row["setting"]) == setting:
                yield method, row


HEADER = ["method", "contacts", "misses", "deepest missed / S", "false contacts", "kBudget", "error: median", "99 %", "max",
          "late, at most", "overlap passed / S", "overlap at t_hit / S", "evaluations: mean", "99 %", "99.9 %", "max",
          "time: median", "99 %", "search alone"]


def _largest(hist):
    return hist.edge(max(hist)) if hist else None


def _cells(label, row):
    error, cost = row["error_free"], row["evaluations"]
    return [label, f"{row['contacts']} of {row['queries']}", str(row["misses"]), number(row["missed_depth"]),
            str(row["false_contacts"]), share(row["said_budget"], row["queries"]),
            number(error.quantile(0.5)), number(error.quantile(0.99)), number(row["worst_error_free"]),
            number(row["worst_late"]), number(row["overlap_passed"]), number(row["overlap_hit"]),
            number(_evaluations(row)), number(cost.quantile(0.99)), number(cost.quantile(0.999)), number(_largest(cost)),
            times(_time(row)), times(row["time_whole_ratio"].quantile(0.99)), times(row["time_search_ratio"].quantile(0.5))]


def _default_tables(rows):
    for scalar in ("float", "double"):
        for family in _families(rows):
            chosen = rows.where(scalar=scalar, family=family)
            yield f"\n#### {family}, {scalar}\n\n"
            yield table(HEADER, [_cells(method, row) for method, row in _default_rows(chosen)])


FIGURES = ["families", "scalar", "contacts: evaluations, mean", "99.9 %", "pairs whose swept boxes meet: mean", "99.9 %",
           "time: median", "99 %", "largest share of kBudget"]
GROUPS = [
    ("generic", ["generic"], "advancement"),
    ("fencing", ["fence60", "fence1ms", "blade"], "advancement"),
    ("all that turn", None, "advancement"),
    ("without rotation", STILL, "translation"),
]


def _figures(rows):
    """The default settings of the library's searches, families taken together."""
    lines = []
    for label, families, method in GROUPS:
        for scalar in ("float", "double"):
            chosen = _turning(rows) if families is None else rows.among(family=families)
            chosen = chosen.where(scalar=scalar, method=method, swept="contact tolerance")
            budgets = [row["said_budget"] / row["queries"] for _, row in _default_rows(chosen)]
            for _, row in _default_rows(chosen.merged(by=["method", "swept", "setting"])):
                lines.append([label, scalar, number(_mean(row, "contact_evaluations")),
                              number(row["contact_evaluations"].quantile(0.999)), number(_mean(row, "near_evaluations")),
                              number(row["near_evaluations"].quantile(0.999)), times(_time(row)),
                              times(row["time_whole_ratio"].quantile(0.99)), share(max(budgets), 1)])
    return table(FIGURES, lines)


def _all_settings(rows, folder):
    lines = [f"# {TITLE}: all settings\n"]
    for scalar in ("float", "double"):
        for family in _families(rows):
            lines.append(f"\n## {family}, {scalar}\n\n")
            lines.append(table(HEADER, [_cells(f"{row['method']}, {row['swept']} {row['setting']}", row)
                                        for row in rows.where(scalar=scalar, family=family).rows]))
    (folder / "search_all.md").write_text("".join(lines))


TEXT = """Every query is answered by every search with one setting swept and the others at their defaults, and held against an
independent truth. Stepping and what is built on it take thousands of evaluations and are asked fewer of the queries.

- *Error*: of `t_free`, the instant at which a caller may stop, over the length of the step; of the contacts that were found.
  What was missed or left open (kBudget) has no error and is counted instead. Near a graze a small contact tolerance is reached early.
- *Missed*: "free" where the truth is contact, however shallow; how deep is told over S, the largest length in the query.
- *False*: contact where the gap stays above the contact tolerance and the rounding.
- *Late*: `t_free` lies after the contact. *Overlap passed*: the deepest one before a late `t_free`, over S.
- *Time*: of a query with the setting up of its pair, as a multiple of one plain segment-segment distance in double (textbook
  form) in the same run.

Stepping, regula falsi and Illinois look for overlaps deeper than epsilon (swept in thinner radii; 0.5 by default), and classic
conservative advancement does not account for rounding: what they miss, they miss by design."""


def page(tables, folder):
    rows = tables["search"]
    _all_settings(rows, folder)
    parts = [TEXT, "\n\n", _both_picture(rows, folder), "\n"]
    parts += [_main_picture(rows, folder, scalar) + "\n" for scalar in ("double", "float")]
    parts += [_evaluation_picture(rows, folder), "\n", _budget_picture(rows, folder), "\n"]
    parts += [_family_picture(rows, folder, scalar) + "\n" for scalar in ("double", "float")]
    parts += ["### The library's searches, contact tolerance 1e-6\n\n", _figures(rows), "\n"]
    parts += ["### Default settings\n\nAll settings: [search_all.md](search_all.md), data: [search.csv](search.csv).\n"]
    return "".join(parts + list(_default_tables(rows)))


def blocks(tables):
    """The README's picture and table: the library's searches at their defaults, in float, family by family."""
    rows = tables["search"].where(scalar="float")
    header = ["family", "contacts", "missed", "false", "kBudget", "error, 99 %", "evaluations, mean", "99.9 %",
              "time, median", "time, 99 %"]
    lines = []
    for family in _families(rows):
        method = "translation" if family in STILL else "advancement"
        row = dict(_default_rows(rows.where(family=family)))[method]
        lines.append([family.replace("_", " "), f"{row['contacts']} of {row['queries']}", str(row["misses"]),
                      str(row["false_contacts"]), share(row["said_budget"], row["queries"]), number(_p99(row)),
                      number(_evaluations(row)), number(row["evaluations"].quantile(0.999)), times(_time(row)),
                      times(row["time_whole_ratio"].quantile(0.99))])
    return {"report": shown(PICTURE, "Error of the time of contact against cost") + table(header, lines)}
