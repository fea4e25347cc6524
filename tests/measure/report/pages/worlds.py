# SPDX-License-Identifier: MIT
"""batuta's world beside Bullet's on the same scenes."""

from markdown import number, share, table
from plot import Panel, Series, draw

TITLE = "Worlds, side by side with Bullet's"
FILES = ["worlds"]

LEAST_ENERGY_ERROR = 1e-7  # a zero on a logarithmic axis
LEAST_DEPTH = 1e-7  # m

PLAYS = {
    "cage": "32 capsules in a cage of fixed ones for 10 s: no weight, nothing is lost in a blow (C = 1), no friction",
    "pile": "32 capsules that fall into a trough of fixed ones for 6 s: C = 0, mu = 0.5, bodies may sleep",
    "volley": "16 rods in flight at 50 m/s, each straight at one of 2 cm that hangs in the air",
}


def _asked(rows, play):
    return [row for row in rows.where(play=play).rows if row["runs"]]


def _time(row):
    """Milliseconds for a second of the scene."""
    return row["time_us"].quantile(0.5) / 1000


def _energy_error(row):
    return max(row["most_energy"] - 1, 1 - row["least_energy"])


def _energy(row):
    return f"{100 * (row['least_energy'] - 1):+.3g} % ... {100 * (row['most_energy'] - 1):+.3g} %"


def _cells(play, row):
    told = {"cage": _energy(row), "pile": number(row["speed_at_end_m_s"]), "volley": _energy(row)}[play]
    return [row["engine"], f"{_time(row):.2f}", told, number(row["deepest_m"] * 1000), f"{row['missed']} of {row['movers']}",
            share(row["incomplete"], row["steps"])]


def _header(play):
    told = "speed at the end, m/s" if play == "pile" else "energy at the end, least ... most"
    missed = "passed through" if play == "volley" else "out of it"
    return ["engine", "ms for a second", told, "deepest penetration, mm", missed, "steps in which something did not fit"]


def _picture(rows, folder):
    panels = []
    for play, what, value in (("cage", "error of the energy", lambda row: max(_energy_error(row), LEAST_ENERGY_ERROR)),
                              ("pile", "deepest penetration, m", lambda row: max(row["deepest_m"], LEAST_DEPTH))):
        series = [Series(row["engine"], [(_time(row), value(row))], look, lines=False)
                  for look, row in enumerate(_asked(rows, play))]
        panels.append(Panel(f"{play}: {what}", "ms for a second of the scene", "", series))
    return draw(folder, "worlds", "Worlds of capsules: error against cost", panels)


TEXT = """The same capsules, masses, moments, restitution and friction for both. batuta: `World` in float with friction, line
contacts, settling and sleep, all defaults. Bullet: `btDiscreteDynamicsWorld`, sequential impulses, ten iterations, in double,
damping off, its threshold of restitution lowered to what batuta calls rest (0.01 m/s). The figure after a name is steps a second;
Bullet's own default is 60. *Touching*: only contacts that touch are solved; by default Bullet brakes a pair from 2 cm away, which at
short steps takes the rebound away. *Swept*: Bullet's continuous detection, which is off unless asked for: it sweeps a ball inside
each body that moves by more than half its radius in a step. Everything is judged in double from the states that the
engines tell, twenty times a second. Times are of one thread of this host.
"""


def page(tables, folder):
    rows = tables["worlds"]
    settings = table(["engine", "as it was asked"], [[row["engine"], row["setting"]] for row in _asked(rows, "cage")])
    parts = [TEXT, "\n", settings, "\n", _picture(rows, folder)]
    for play, what in PLAYS.items():
        parts.append(f"\n### {play.capitalize()}\n\n{what[0].upper()}{what[1:]}.\n\n")
        parts.append(table(_header(play), [_cells(play, row) for row in _asked(rows, play)]))
    return "".join(parts + ["\nData: [worlds.csv](worlds.csv).\n"])
