# SPDX-License-Identifier: MIT
"""The campaign against what the certified searches claim."""

from markdown import number, share, table
from plot import Panel, Series, draw

TITLE = "Misses: the claims of the certified searches"
FILES = ["misses"]

OUTCOMES = ["free", "contact", "touching", "budget", "invalid"]
LEAST_SHARE = 1e-7  # a zero on a logarithmic axis


def _whole(rows):
    """The searches as they are: with all of their inflation."""
    return type(rows)(rows.kinds, [row for row in rows.rows if float(row["inflation"]) == 1])


def _queries(row):
    return sum(row[outcome] for outcome in OUTCOMES)


def _mean(hist):
    """Of whole numbers below 64 exactly, of others to the width of a bin."""
    return sum(hist.edge(b) * n for b, n in hist.items()) / hist.count if hist else None


def _largest(hist):
    return hist.edge(max(hist)) if hist else None


HEADER = ["queries", "tried", "missed", "late", "false contacts", "slack beyond the contact tolerance", "disordered", "invalid", "kBudget",
          "not told by the reference", "hits: evaluations, mean", "99.9 %", "max", "free: mean", "max"]


def _cells(label, row):
    hits, free = row["hit_evaluations"], row["free_evaluations"]
    return [label, str(_queries(row)), str(row["missed"]), str(row["late"]), str(row["false_contacts"]), str(row["loose"]),
            str(row["disordered"]), str(row["invalid"]), share(row["budget"], _queries(row)), str(row["open"]),
            number(_mean(hits)), number(hits.quantile(0.999)), number(_largest(hits)), number(_mean(free)),
            number(_largest(free))]


def _tables(rows):
    whole = _whole(rows)
    yield table(HEADER, [_cells(f"all, {row['search']}, {row['scalar']}", row)
                         for row in whole.merged(by=["scalar", "search"]).rows])
    yield "\n#### By family\n\n"
    yield table(HEADER, [_cells(f"{row['family'].replace('_', ' ')}, {row['search']}, {row['scalar']}", row)
                         for row in whole.rows])


def _swept(rows):
    """The family that was asked with less and less of the inflation."""
    families = {row["family"] for row in rows.rows if float(row["inflation"]) != 1}
    return rows.among(family=families).merged(by=["scalar", "inflation"])


def _inflation_picture(rows, folder):
    shares, depths = [], []
    for look, scalar in enumerate(("float", "double")):
        ordered = sorted(rows.where(scalar=scalar).rows, key=lambda row: float(row["inflation"]))
        untrue = [(float(row["inflation"]), max((row["missed"] + row["late"]) / _queries(row), LEAST_SHARE)) for row in ordered]
        shares.append(Series(scalar, untrue, look))
        depths.append(Series(scalar, [(float(row["inflation"]), row["overlap_uS"] or 0) for row in ordered], look))
    left = "inflation that is left (1: all of it, below 0: taken off)"
    deepest = max((y for series in depths for _, y in series.points), default=0)
    panels = [Panel("untrue claims (none: at the bottom)", left, "share of the queries", shares, logs="y", y_range=(LEAST_SHARE, 1)),
              Panel("deepest overlap that was called free", left, "over u S", depths, logs="", y_range=(0, max(deepest, 1)))]
    return draw(folder, "misses", "Grazes with less than the inflation that rounding needs", panels)


TEXT = """Every claim is held against the reference: *missed*, "free" where there is overlap; *late*, overlap at or before `t_free`;
*false*, contact where the gap is above the contact tolerance and twice the inflation; *slack*, a contact whose gap at `t_free` is above the contact tolerance
and the inflation; *disordered*, not 0 <= `t_free` <= `t_hit` <= duration. Part of the claims are also probed with dense samples.
The inflation is what a search adds to the radii for its rounding; grazes are asked again with less of it.

"""


def page(tables, folder):
    rows = tables["misses"]
    probed, overlaps = (sum(row[name] for row in _whole(rows).rows) for name in ("probed", "probe_overlaps"))
    return "".join([TEXT, *_tables(rows), f"\nProbed: {probed}; overlap found in what was called free: {overlaps}.\n\n",
                    _inflation_picture(_swept(rows), folder), "\nData: [misses.csv](misses.csv).\n"])
