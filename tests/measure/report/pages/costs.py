# SPDX-License-Identifier: MIT
"""What a step of many bodies costs beside Bullet's."""

from markdown import share, table
from plot import Panel, Series, draw

TITLE = "What a step of many bodies costs"
FILES = ["costs"]

BOUNDS = {"standing": 1.5, "collapsing": 4, "sparse": 0.8}  # over Bullet's time


def _ours(row):
    """Microseconds of a step; the middle of the runs."""
    return row["time_us"].quantile(0.5)


def _bullets(row):
    return row["time_of_bullet_us"].quantile(0.5)


def _over(row):
    over = row["time_over_bullet"].quantile(0.5)
    bound = BOUNDS[row["scene"]]
    if over is None:
        return "-"
    return f"{over:.2f} ×" + (f" **above {bound}**" if over > bound else "")


def _room(row):
    """For how many bodies the world had room: as room_for() of costs.cpp."""
    room = 32
    while room < int(row["bodies"]):
        room *= 2
    return room


def _cells(row, before):
    bullet = _bullets(row)
    growth = f"{_ours(row) / before:.2f} ×" if before else "-"
    return [row["scene"], row["bodies"], row["hz"], f"{_ours(row):.1f}", "-" if bullet is None else f"{bullet:.1f}", _over(row), growth,
            share(row["incomplete"], row["steps"]), f"{row['bytes'] / _room(row):.0f}"]


def _lines(rows):
    sparse = {int(row["bodies"]): _ours(row) for row in rows if row["scene"] == "sparse"}
    for row in rows:
        yield _cells(row, sparse.get(int(row["bodies"]) // 2) if row["scene"] == "sparse" else None)


def _picture(rows, folder):
    panels = []
    for what, shown in (("at 60 steps a second", "60"), ("at 1000 steps a second", "1000")):
        series = []
        for look, scene in enumerate(BOUNDS):
            chosen = [row for row in rows if row["scene"] == scene and row["hz"] == shown]
            series.append(Series(scene, [(int(row["bodies"]), _ours(row)) for row in chosen], look))
            series.append(Series(f"{scene}, Bullet", [(int(row["bodies"]), _bullets(row)) for row in chosen if _bullets(row) is not None],
                                 look, dashed=True))
        panels.append(Panel(f"µs a step, {what}", "bodies", "", series))
    return draw(folder, "costs", "Worlds of many bodies: time of a step", panels)


TEXT = """Nobody sleeps; one thread; both engines make each step in turn, and the time is that of the step alone, the mean of a run; the middle of the
runs is shown. *Standing* and *collapsing*: bars of 0.3 m crossed in layers of four on eight fixed logs (counted), C = 0.2, mu = 0.5: at
60 steps a second more than some 40 fall over, and what that takes is the second kind. A run of the first ends where one of the towers falls
(Bullet's of 40 within 2 s). *Sparse*: capsules in flight, half a metre to the next
one. Bullet with all its defaults, in double. *Steps that were not complete*: in which batuta says that something did not fit, and bodies went
on together. Bytes are those of the world with room for the next power of two of bodies.
"""


def page(tables, folder):
    rows = [row for row in tables["costs"].rows if row["steps"]]
    header = ["scene", "bodies", "steps a second", "µs a step", "Bullet", "over Bullet", "over half as many", "steps that were not complete",
              "bytes a body"]
    return "".join([TEXT, "\n", _picture(rows, folder), "\n", table(header, list(_lines(rows))), "\nData: [costs.csv](costs.csv).\n"])
