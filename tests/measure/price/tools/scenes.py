# SPDX-License-Identifier: MIT
"""The scenes: what each takes beyond an empty image, what a feature costs (the difference of two scenes), how a scene
compares with the same one written by hand, and which symbols must not be in it."""

import collections
import os
import re
import subprocess

from . import budgets, instructions

EMPTY = "empty"
BY_HAND = "_by_hand"

STEP = "price_scene_step"  # the root of a scene's stack
SCENE_STEP, SCENE_STATE = 10, 11

# The run: steps of a millisecond, and the restitution in tenths. Two scenes are run at 0 as well, to be compared with one
# that has none.
STEPS = 200
BOUNCY, DULL = 6, 0
RUN_DULL = "TwoBlades", "NoRestitution"
# Too long a run for arithmetic in software.
LONG = "Rack",
# A long step takes more of the counter than a short one: fewer ticks an instruction there.
SHIFT = collections.defaultdict(lambda: instructions.SHIFT, {"Rack": 2})

# One feature: the scene that has it, and the one that differs by having it not. `dull`: compared in the run without
# restitution. Alternatives have no order: neither has to be the cheaper one.
Feature = collections.namedtuple("Feature", "label fuller leaner dull is_alternative", defaults=(False, False))
FEATURES = [
    Feature("restitution", "TwoBlades", "NoRestitution", dull=True),
    Feature("response: impulse with restitution", "RestingNone", "NoResponse"),
    Feature("resting contact: separation", "TwoBlades", "RestingNone"),
    Feature("resting contact: settling", "RestingSettling", "RestingNone"),
    Feature("friction", "Friction", "RestingSettling"),
    Feature("line contact", "LineContact", "TwoBlades"),
    Feature("gravity", "Gravity", "TwoBlades"),
    Feature("sleep", "Sleep", "RestingSettling"),
    Feature("events", "TwoBlades", "NoEvents"),
    Feature("events of eight balls", "SpheresWithEvents", "StraightSpheres"),
    Feature("owners", "TwoBlades", "NoOwners"),
    Feature("filters", "Filters", "TwoBlades"),
    Feature("a second capsule of each body", "TwoParts", "TwoBlades"),
    Feature("rotation", "Unturned", "NoRotation"),
    Feature("capsules in place of balls", "NoRotation", "Balls"),
    Feature("Advancement in place of Translation", "TwoBlades", "WithTranslation", is_alternative=True),
    Feature("Advancement in place of Stepping", "TwoBlades", "WithStepping", is_alternative=True),
    Feature("SweptBox in place of CoarseBox", "TwoBlades", "WithCoarseBox", is_alternative=True),
]
FIGURES = "flash", "ram", "stack", "step.free", "step.hit"  # the stack's deepest path may lead elsewhere: no order

# What is not used changes no bit, and what is written by hand does the same job: these runs end alike. Eight balls by hand
# round otherwise; they have the same contacts in the same steps.
ALIKE = [("TwoBlades", "TwoBlades_by_hand"), ("DetectionOnly", "DetectionOnly_by_hand"), ("TwoBlades", "NoEvents"),
         ("TwoBlades", "NoOwners"), ("TwoBlades", "Filters"), ("DetectionOnly", "NoResponse")]
SAME_CONTACTS = [(name, name + BY_HAND) for name in budgets.BY_HAND]

# Where to leave something out does cost, and why that is meant: (leaner scene, figure).
MEANT = {
    ("StraightSpheres", "step.free"): "few balls without events need neither boxes nor candidate pairs: less than half the flash, but "
                                      "every pair is searched in every step",
    ("StraightSpheres", "step.hit"): "as step.free: all pairs are searched again after a contact",
}

# What a feature may seem to save by where the compiler puts things: bytes of flash and RAM, share of the instructions.
LAYOUT_BYTES = 64
LAYOUT_SHARE = 0.01

# What is left out is not in the image: names, as c++filt writes them, that a scene must not have.
TURNING = r"Quaternion|\bpose_at<|\b(free|steady)_flight<|\bsin_cos|\barc_|\bcapsule_path|\bswept_aabb<"
RESPONSE = r"_impulse<|\bseparate<|\bresolve_contact<"
EXTRAS = r"\bfriction_impulse<|\bpressure_contact<|\bcoarse_swept|Grip|Duel|Fencer"
OTHER_SEARCHES = r"\bsearch_(translation|stepping|spheres)<"
SEEING = r"Opponent|SeeingRival|DelayedObservation|\bobservation_of<|\bfencer_seen<"
NEVER = {
    "duel": [SEEING, OTHER_SEARCHES],
    "duel_stepping": [SEEING, r"\bsearch_(translation|advancement|spheres)<"],
    "firmware": [SEEING, OTHER_SEARCHES],
    "firmware_opponent": [OTHER_SEARCHES],
    "StraightSpheres": [TURNING, EXTRAS, r"\bcollision_impulse<|\bseparate<|\bresolve_contact<", r"ContactEvent",
                        r"\bsearch_(advancement|translation|stepping)<", r"\bclosest_points<"],
    "DetectionOnly": [RESPONSE, EXTRAS, OTHER_SEARCHES],
    "TwoBlades": [EXTRAS, OTHER_SEARCHES, r"\bstraight_"],
    "Rack": [r"\bcoarse_swept|Grip|Duel|Fencer", OTHER_SEARCHES, r"\bstraight_"],
    "NoResponse": [RESPONSE, EXTRAS, OTHER_SEARCHES],
    "NoEvents": [r"ContactEvent"],
    "NoRotation": [TURNING, EXTRAS, r"\bcollision_impulse<|\bseparate<|\bresolve_contact<"],
    "WithTranslation": [r"\bsearch_(advancement|stepping|spheres)<"],
    "WithStepping": [r"\bsearch_(translation|advancement|spheres)<"],
    "WithCoarseBox": [r" batuta::swept_aabb<"],
}


def linked_in_vain(name, image):
    """A line for each symbol of an image that the scene has left out."""
    patterns = NEVER.get(name, [])
    for symbol in sorted({symbol.demangled for symbol in image.symbols if symbol.kind not in "Uw"}):
        if any(re.search(pattern, symbol) for pattern in patterns):
            yield f"left out, but linked: {symbol}"


def run(name, manifest, folder, restitution):
    """Samples of a scene's run in the emulator."""
    out = folder / "scene.bin"
    command = [*manifest["emulator"], manifest["scenes"][name]["run"], str(out), str(restitution), str(STEPS)]
    environment = dict(os.environ, BATUTA_QEMU_OPTIONS=f"-icount shift={SHIFT[name]}")
    subprocess.run(command, check=True, env=environment, timeout=7200)
    return instructions.Samples(out.read_bytes())


def step_figures(samples):
    """Instructions of the steps: of all, of those before the first contact, and of the one in which that is."""
    rows = [row for _, row in samples.of(SCENE_STEP)]
    if any(row.b for row in rows):
        raise ValueError("a step was refused")
    hit = next((i for i, row in enumerate(rows) if row.a), None)
    if not hit:
        raise ValueError("a run without a contact, or with one in the first step, tells nothing")
    costs = [samples.count(row.ticks) for row in rows]
    return {"step.free": instructions.quantile(costs[:hit], 0.5), "step.hit": costs[hit],
            "step.median": instructions.quantile(costs, 0.5), "step.max": max(costs)}


def contacts_of(samples):
    """Of each step."""
    return [row.a for _, row in samples.of(SCENE_STEP)]


def state_of(samples):
    (_, row), = samples.of(SCENE_STATE)
    return row.index


def unlike(pairs, of, what):
    """A line for each two runs that should be the same, and are not. @param of  scene -> what is compared"""
    for one, other in pairs:
        if one in of and other in of and of[one] != of[other]:
            yield f"{one} and {other} do not {what}"


def unlike_runs(runs):
    """@param runs  scene -> samples of its run"""
    states = {name: state_of(samples) for name, samples in runs.items()}
    contacts = {name: contacts_of(samples) for name, samples in runs.items()}
    return [*unlike(ALIKE, states, "end in the same bits"), *unlike(SAME_CONTACTS, contacts, "have the same contacts")]


def suffix(restitution):
    return "" if restitution == BOUNCY else ".dull"


def prices(figures):
    """(feature, figure -> what it costs more) where both scenes were measured."""
    for feature in FEATURES:
        dull = suffix(DULL) if feature.dull else ""
        costs = {}
        for figure in FIGURES:
            names = [f"{scene}{dull if figure.startswith('step') else ''}.{figure}" for scene in feature[1:3]]
            if all(name in figures for name in names):
                costs[figure] = figures[names[0]] - figures[names[1]]
        if costs:
            yield feature, costs


def savings(figures):
    """(key of MEANT, text) of each feature that costs less than nothing: to leave it out costs flash or time."""
    for feature, costs in prices(figures):
        for figure, cost in costs.items():
            room = LAYOUT_BYTES
            if figure.startswith("step"):
                room = LAYOUT_SHARE * figures[f"{feature.fuller}.{figure}"]
            if figure != "stack" and not feature.is_alternative and cost < -room:
                yield (feature.leaner, figure), f"{feature.leaner} takes {-cost:,} more than {feature.fuller}: {figure}"


def savings_not_meant(figures):
    return [text for key, text in savings(figures) if key not in MEANT]


def table(figures):
    """Text for the console: the scenes, and the features."""
    heads = *FIGURES, "step.median", "step.max", "flash_of_by_hand"
    lines = [f"{'scene, beyond an empty image':40}" + "".join(f"{head:>14}" for head in (*heads[:-1], "% of by hand"))]
    names = [name[:-len(".flash")] for name in figures if name.endswith(".flash")]
    for name in names:
        if f"{name}.step.free" in figures or name in budgets.SCENES:
            lines.append(f"{name:40}" + "".join(f"{budgets.number(figures.get(f'{name}.{head}')):>14}" for head in heads))
    lines.append(f"{'feature':40}" + "".join(f"{head:>14}" for head in FIGURES))
    for feature, costs in prices(figures):
        lines.append(f"{feature.label:40}" + "".join(f"{costs.get(head, 0):>+14,}" for head in FIGURES))
    lines += [f"{text} ({MEANT[key]})" for key, text in savings(figures) if key in MEANT]
    return "\n".join(lines)
