# SPDX-License-Identifier: MIT
"""Instructions of the kernels, the searches and the step, as the bench program counts them under QEMU's -icount."""

import collections
import csv
import os
import pathlib
import struct
import subprocess

from . import budgets

# One instruction takes 2^SHIFT ns of the emulated clock: more than one tick of SysTick at 20 MHz and above, so that a
# count is right to within one, and few enough that 2^23 ticks hold the longest step in software floating point.
SHIFT = 6

# SysTick counts 2^24 ticks. What takes half of that is refused: more could not be told from less.
MOST_TICKS = 1 << 23

# How much is measured: every so many-th query, and the first so many steps of a bout. All of it where bounds are
# promised; elsewhere a part, for arithmetic in software takes ten times as long.
ALL, WITH_FPU, WITHOUT_FPU = (1, 1_000_000), (1, 4000), (16, 1200)

MAKE_PAIR, SEARCH, SEGMENT, IMPULSE, STEP, CONFIGURE, STACK = range(3, 10)
# What a bout costs with another choice (emulated.cmake, "choices"), or a part of it: of the first so many steps of each
# recording; SHIFT as above, less where a step is longer.
Choice = collections.namedtuple("Choice", "steps shift")
CHOICES = {"duel_stepping": Choice(4000, 4), "opponent": Choice(4000, SHIFT)}
COMPARED_STEPS = CHOICES["duel_stepping"].steps
BOUTS_ONLY = 1_000_000_000  # of the queries the first

BOUT = "price_bout"
ROOTS = {1: "price_search", 2: "price_segments", 3: "price_impulses", 4: BOUT}
OUTCOMES = ("free", "contact", "touching", "budget", "invalid")

Sample = collections.namedtuple("Sample", "kind index ticks a b c")

TOC = 1
BODY_FIELDS = ("c", 3), ("q", 4), ("v", 3), ("w", 3), ("e0", 3), ("e1", 3), ("r", 1)


def bits(text):
    """A number of a query file: hexadecimal bits of a float, trailing zeros left out."""
    return int(text.ljust(8, "0"), 16)


def body_columns(body):
    for field, count in BODY_FIELDS:
        axes = {1: [""], 3: ["x", "y", "z"], 4: ["w", "x", "y", "z"]}[count]
        yield from (body + field + axis for axis in axes)


def chunk_of_contacts(path):
    """A query file of times of contact as a chunk of the digest's file."""
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    columns = ["T", *body_columns("A"), *body_columns("B")]
    words = [bits(row[column]) for row in rows for column in columns]
    return struct.pack(f"<4I{len(words)}I", TOC, len(rows), len(columns), 0, *words)


def whole_file(manifest_shared):
    return pathlib.Path(manifest_shared) / "vectors" / "toc.csv"


def packed_queries(manifest, folder):
    """The digest's queries, made by the program of the host's tree, or left by tests/target/pairs; else None. None,
    too, without the whole file of queries: what is budgeted are figures of all of them."""
    if not whole_file(manifest["shared"]).is_file():
        return None
    build = pathlib.Path(manifest["source"]) / "build"
    packer = build / "host" / "batuta_digest_pack"
    if (build / "host" / "CMakeCache.txt").is_file() and not packer.is_file():
        subprocess.run(["cmake", "--build", packer.parent, "--target", packer.name], stdout=subprocess.DEVNULL)
    if packer.is_file():
        out = folder / "digest.bin"
        subprocess.run([packer, manifest["shared"], out], check=True, stdout=subprocess.DEVNULL)
        return out
    left = build / "digest" / "digest.bin"
    return left if left.is_file() else None


def find_queries(given, manifest, folder):
    """The digest's queries and the worst ones in one file; None where there are none."""
    packed = given or packed_queries(manifest, folder)
    if packed is None:
        return None
    joined = folder / "queries.bin"
    worst = pathlib.Path(manifest["source"]) / "tests" / "vectors" / "worst_queries.csv"
    joined.write_bytes(packed.read_bytes() + chunk_of_contacts(worst))
    return joined


def effort(manifest):
    if manifest["cpu"] == budgets.BOUND_CPU:
        return ALL
    return WITH_FPU if manifest["has_fpu"] else WITHOUT_FPU


def run(manifest, queries):
    """Runs the bench in the emulator."""
    return run_bench(manifest, manifest["bench"], queries, *effort(manifest), SHIFT)


def run_choice(manifest, name, queries):
    choice = CHOICES[name]
    return run_bench(manifest, manifest["choices"][name], queries, BOUTS_ONLY, *choice)


def run_bench(manifest, bench, queries, every, steps, shift, options=""):
    out = queries.with_name("samples.bin")
    command = manifest["emulator"] + [bench, str(queries), str(out), str(every), str(steps)]
    environment = dict(os.environ, BATUTA_QEMU_OPTIONS=f"-icount shift={shift} {options}")
    subprocess.run(command, check=True, env=environment, timeout=7200)
    return Samples(out.read_bytes())


class Samples:
    """What the bench wrote, in instructions."""

    def __init__(self, data):
        rows = [Sample(*words) for words in struct.iter_unpack("<6I", data)]
        calibration, reading = rows[0], rows[1]
        self.ticks_per_instruction = (calibration.ticks - reading.ticks) / calibration.index
        self.overhead = reading.ticks
        self.chunks = [[]]  # samples up to and with each STACK
        for row in rows[2:]:
            if row.kind != STACK and row.ticks >= MOST_TICKS:
                raise ValueError(f"{row} is too long for the counter, which may have wrapped elsewhere: lower SHIFT")
            self.chunks[-1].append(row)
            if row.kind == STACK:
                self.chunks.append([])

    def count(self, ticks):
        return round((ticks - self.overhead) / self.ticks_per_instruction)

    def difference(self, ticks):
        return round(ticks / self.ticks_per_instruction)

    def of(self, kind):
        """(chunk number, sample) of one kind."""
        return [(number, row) for number, chunk in enumerate(self.chunks) for row in chunk if row.kind == kind]

    def counts(self, kind):
        return [self.count(row.ticks) for _, row in self.of(kind)]

    def stacks(self):
        """root -> deepest painted stack below it, B."""
        deepest = collections.Counter()
        for _, row in self.of(STACK):
            root = ROOTS[row.index]
            deepest[root] = max(deepest[root], row.ticks)
        return dict(deepest)


def quantile(values, share):
    """What so large a share of the values does not exceed."""
    ordered = sorted(values)
    return ordered[max(0, -int(-share * len(ordered) // 1) - 1)]


def spread(name, values):
    """Median, 99.9 % and most."""
    if not values:
        return {}
    shares = (("median", 0.5), ("99.9%", 0.999), ("max", 1))
    return {f"{name}.{word}": quantile(values, share) for word, share in shares}


def mean(values):
    return round(sum(values) / len(values))


def families(manifest_shared):
    with whole_file(manifest_shared).open(newline="") as file:
        return [row["family"] for row in csv.DictReader(file)]


def search_figures(samples, family_of):
    searches = samples.of(SEARCH)
    first = searches[0][0]
    figures = {}
    generic = [row for chunk, row in searches if chunk == first and family_of[row.index] == "generic"]
    figures["search.generic.mean"] = mean([samples.count(row.ticks) for row in generic])
    for outcome, number in (("hit", OUTCOMES.index("contact")), ("miss", OUTCOMES.index("free"))):
        costs = [samples.count(row.ticks) for row in generic if row.a == number]
        figures[f"search.generic.{outcome}.mean"] = mean(costs)
        figures.update(spread(f"search.generic.{outcome}", costs))
    vectors = [samples.count(row.ticks) for chunk, row in searches if chunk == first]
    figures.update(spread("search.vectors", vectors))
    worst = max(searches, key=lambda pair: pair[1].ticks)[1]
    figures["search.worst"] = samples.count(worst.ticks)
    figures["search.worst.evaluations"] = worst.b
    figures["search.most_evaluations"] = max(row.b for _, row in searches)
    figures.update(spread("search.evaluation", [samples.difference(row.c) for _, row in searches if row.c]))
    return figures


def step_figures(name, samples, steps=None):
    """@param steps  of each recording the first so many, or all"""
    rows = [row for _, row in samples.of(STEP) if steps is None or row.index < steps]
    return spread(f"{name}.step", [samples.count(row.ticks) for row in rows])


def figures(samples, family_of):
    """name -> instructions, but for sizes and counts that say so."""
    found = spread("segment_segment", samples.counts(SEGMENT))
    found.update(spread("make_moving_pair", samples.counts(MAKE_PAIR)))
    found.update(search_figures(samples, family_of))
    found.update(spread("impulse", [samples.count(row.ticks) for _, row in samples.of(IMPULSE) if row.a]))
    found.update(step_figures("duel", samples))
    found.update(step_figures("duel.compared", samples, COMPARED_STEPS))
    found["duel.rate_at_133_MHz"] = 133_000_000 // found["duel.step.99.9%"]  # Hz, if an instruction took one cycle
    found["duel.steps"] = len(samples.of(STEP))
    found["duel.configure"] = max(samples.counts(CONFIGURE))
    return found
