# SPDX-License-Identifier: MIT
"""Cycles of a duel's step on a Cortex-M4F, from above: a plugin of QEMU prices each instruction (docs/cycles.md)."""

import pathlib
import shutil
import struct
import subprocess

from . import instructions

SOURCE = pathlib.Path(__file__).parent.parent / "cycles" / "cycles.c"
CLOCK_STEP = 168_000  # cycles of 1 ms at 168 MHz

# Instructions by the plugin and by SysTick are the same but for the rounding of ticks.
ROUNDING = 4


def build(folder):
    """The plugin; None without a compiler for this machine."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        return None
    plugin = folder / "cycles.so"
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "-Wl,-z,lazy", "-o", plugin, SOURCE], check=True)
    return plugin


def read_spans(path):
    """(instructions, cycles) between the marks of each measurement."""
    marks = list(struct.iter_unpack("<2Q", path.read_bytes()))
    return [(end[0] - start[0], end[1] - start[1]) for start, end in zip(marks[::2], marks[1::2])]


def measurements_of(row):
    """What was measured for a sample: a search of more than two evaluations twice more, to tell what one takes."""
    if row.kind == instructions.STACK:
        return 0
    return 3 if row.kind == instructions.SEARCH and row.b > 2 else 1


def of_steps(samples, spans):
    """Cycles of each step of the bouts. Spans are in the order of samples, after that of an empty measurement, and have as
    many instructions as SysTick says."""
    nothing = spans[0]
    next_span = 1
    found = []
    for row in (row for chunk in samples.chunks for row in chunk):
        if row.kind == instructions.STEP:
            count, cycles = (of_span - of_nothing for of_span, of_nothing in zip(spans[next_span], nothing))
            if abs(samples.count(row.ticks) - count) > ROUNDING:
                raise ValueError(f"{row}: the plugin counts {count} instructions")
            found.append(cycles)
        next_span += measurements_of(row)
    if next_span != len(spans):
        raise ValueError(f"{len(spans)} measurements by the plugin, {next_span} by the program")
    return found


def figures(manifest, queries):
    """name -> cycles; nothing where the plugin cannot be built."""
    folder = queries.parent
    plugin = build(folder)
    if plugin is None:
        return {}
    out = folder / "cycles.bin"
    samples = instructions.run_bench(manifest, manifest["bench"], queries, instructions.BOUTS_ONLY,
                                     instructions.ALL[1], instructions.SHIFT, f"-plugin file={plugin},out={out}")
    steps = of_steps(samples, read_spans(out))
    found = instructions.spread("duel.step.cycles", steps)
    found["duel.step.cycles.over_1_ms"] = sum(1 for step in steps if step > CLOCK_STEP)
    return found
