#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the library costs on a part: collects sizes, stack and instructions of a target's build tree, compares them with
budgets.csv, prints them and writes price.json into the tree.
Exit code 0: within the budgets; 1: over a budget, or a gate found something; 77: the same as 0, but there were no
queries to count instructions with."""

import argparse
import json
import pathlib
import sys

from tools import budgets, cycles, footprint, forbidden, instructions, rooms, scenes, stack, stack_graph
from tools.image import Image
from tools.scene_collector import SceneCollector

HERE = pathlib.Path(__file__).resolve().parent
BUDGETS = HERE / "budgets.csv"
SKIPPED = 77
SIZE_PREFIX = "price_sizeof_"


def read_manifest(tree):
    """Of a build tree, wherever in it this folder was built."""
    found = sorted(tree.rglob("price/manifest.json"))
    if len(found) != 1:
        sys.exit(f"{tree}: {len(found)} files price/manifest.json, not one: is it a target's tree, and configured?")
    return json.loads(found[0].read_text()), found[0].parent


class Collector:
    """Figures of one tree, name -> number; what goes with them; and what the gates found."""

    def __init__(self, manifest):
        self.manifest = manifest
        self.names = rooms.declared_names(pathlib.Path(manifest["source"]))
        self.compiled = stack_graph.compiled_files(pathlib.Path(manifest["tree"]))
        self.rules = stack.read_rules(HERE / "call_rules.txt")
        self.figures = {}
        self.rooms = {}  # image -> room -> (flash, RAM)
        self.paths = {}  # image -> the deepest paths
        self.biggest = {}  # image -> its largest symbols
        self.findings = []

    def image(self, path):
        return Image(path, self.manifest["tools"])

    def worst_case(self, image):
        return stack.WorstCase(stack_graph.CallGraph(image, self.compiled), self.rules)

    def take_image(self, name, path):
        image = self.image(path)
        worst = self.worst_case(image)
        self.findings += [f"{name}: {text}" for text in
                          (*forbidden.texts(image, worst.graph), *scenes.linked_in_vain(name, image))]
        self.rooms[name] = rooms.by_room(image, self.names)
        self.biggest[name] = rooms.biggest(image, self.names, 20)
        self.figures[f"{name}.flash"], self.figures[f"{name}.ram"] = self.rooms[name]["total"]
        depth, self.paths[name] = worst.with_interrupts("batuta_reset", self.manifest["has_fpu"])
        self.figures[f"{name}.stack"] = depth
        worst.compare("batuta_reset with interrupts", depth, "batuta_stack_size")
        worst.compare("batuta_fault", worst.of("batuta_fault").bytes, "batuta_fault_stack_size")
        self.findings += [f"{name}: {text}" for text in worst.findings.values()]

    def take_differences(self):
        """What an opponent takes beyond the firmware without."""
        if "firmware_opponent.flash" in self.figures:
            for kind in ("flash", "ram"):
                more = self.figures[f"firmware_opponent.{kind}"] - self.figures[f"firmware.{kind}"]
                self.figures[f"opponent.{kind}"] = more

    def take_sizes(self):
        sizes = {symbol.name[len(SIZE_PREFIX):]: symbol.size for symbol in self.image(self.manifest["sizes"]).symbols
                 if symbol.name.startswith(SIZE_PREFIX)}
        buffers = sizes.pop("buffers", 0)
        if "firmware.ram" in self.figures:
            self.figures["firmware.ram_without_buffers"] = self.figures["firmware.ram"] - buffers
        self.figures.update((f"sizeof.{name}", size) for name, size in sizes.items())

    def take_bench(self, queries):
        samples = instructions.run(self.manifest, queries)
        self.figures.update(instructions.figures(samples, instructions.families(self.manifest["shared"])))
        self._compare_stacks(self.manifest["bench"], samples.stacks(), "")
        if self.manifest["cpu"] == budgets.BOUND_CPU:
            self.figures.update(cycles.figures(self.manifest, queries))
        for name, bench in self.manifest["choices"].items():
            samples = instructions.run_choice(self.manifest, name, queries)
            self.figures.update(instructions.step_figures(name, samples))
            of_bouts = {instructions.BOUT: samples.stacks()[instructions.BOUT]}
            self._compare_stacks(bench, of_bouts, f".{name}")

    def _compare_stacks(self, bench, painted, end):
        """Painted against computed, for these functions of a bench."""
        worst = self.worst_case(self.image(bench))
        for root, measured in painted.items():
            computed = worst.of(root).bytes
            self.figures[f"painted_stack.{root}{end}"] = measured
            self.figures[f"computed_stack.{root}{end}"] = computed
            if not computed // 2 <= measured <= computed:
                self.findings.append(f"bench: {root}{end}: {measured} B of stack used, {computed} B computed")

    def write(self, folder):
        found = {"cpu": self.manifest["cpu"], "part": self.manifest["part"], "board": self.manifest["board"],
                 "figures": self.figures, "rooms": self.rooms, "findings": self.findings}
        (folder / "price.json").write_text(json.dumps(found, indent=1) + "\n")


def print_rooms(by_image):
    """Flash and RAM, a line for each room, two columns for each image."""
    order = sorted({room for sizes in by_image.values() for room in sizes},
                   key=lambda room: -max(sizes.get(room, (0, 0))[0] for sizes in by_image.values()))
    print(f"{'flash / RAM by room, B':24}" + "".join(f"{name:>20}" for name in by_image))
    for room in order:
        print(f"{room:24}" + "".join("{:>12,}{:>8,}".format(*sizes.get(room, (0, 0))) for sizes in by_image.values()))


def print_details(collector):
    for name in collector.rooms:
        print(f"\n{name}: largest symbols, B")
        for size, room, symbol in collector.biggest[name]:
            print(f"  {size:8,}  {room:12}{symbol[:100]}")
        for part, path in collector.paths[name]:
            print(f"{name}: deepest stack of {part}: {path.bytes:,} B")
            for readable, frame in path.steps:
                print(f"  {frame:8,}  {readable[:112]}")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tree", type=pathlib.Path, required=True, help="build tree of a target")
    parser.add_argument("--queries", type=pathlib.Path, help="file of batuta_digest_pack; default: made by it")
    parser.add_argument("--scenes", action="store_true", help="only the scenes (target price-scenes); nothing is kept or written")
    parser.add_argument("--without-instructions", action="store_true", help="nothing is run")
    parser.add_argument("--verbose", action="store_true", help="largest symbols and deepest stacks, too")
    parser.add_argument("--keep", action="store_true",
                        help="write what was reached into budgets.csv: what of it, budgets.py says by part")
    return parser.parse_args()


def take_scenes(collector, options, folder):
    of_scenes = SceneCollector(collector)
    of_scenes.take_images()
    if not options.without_instructions:
        of_scenes.take_runs(folder)
    collector.findings += [f"scenes: {text}" for text in scenes.savings_not_meant(collector.figures)]


def show_scenes(options, manifest, folder):
    """What is found while a scene is worked on, in a minute. @returns exit code"""
    collector = Collector(manifest)
    take_scenes(collector, options, folder)
    print(scenes.table(collector.figures))
    print("\n".join(f"GATE {text}" for text in collector.findings) or "the gates found nothing")
    return 1 if collector.findings else 0


def collect(options, manifest, folder):
    collector = Collector(manifest)
    for name, path in manifest["images"].items():
        if pathlib.Path(path).is_file():
            collector.take_image(name, path)
        else:
            print(f"{name}: not built")
    collector.take_differences()
    is_complete = True
    if "bench" in manifest:
        collector.take_sizes()
        queries = None if options.without_instructions else instructions.find_queries(options.queries, manifest, folder)
        is_complete = queries is not None
        if is_complete:
            collector.take_bench(queries)
    if "scenes" in manifest:
        take_scenes(collector, options, folder)
    collector.write(folder)
    return collector, is_complete


def main():
    options = parse()
    manifest, folder = read_manifest(options.tree)
    if options.scenes:
        return show_scenes(options, manifest, folder)
    collector, is_complete = collect(options, manifest, folder)
    part = manifest["part"]
    footprint.write(pathlib.Path(manifest["source"]) / "build")
    if options.keep:
        budgets.keep(BUDGETS, part, collector.figures, budgets.kept_figures(part))
    rows = budgets.compare(budgets.read(BUDGETS), part, collector.figures)
    if not is_complete:
        rows = [row for row in rows if row.value is not None]
    counting = " Instructions are counted by QEMU's -icount; cycles are a bound from above (docs/cycles.md)." if "bench" in manifest else ""
    print(f"{part} on {manifest['board']}.{counting}")
    print_rooms(collector.rooms)
    if options.verbose:
        print_details(collector)
    if "scenes" in manifest:
        print(scenes.table(collector.figures))
        rows = [row for row in rows if any(row.limits) or row.figure.split(".")[0] not in manifest["scenes"]]
    print(budgets.table(rows))
    print("\n".join(f"GATE {text}" for text in collector.findings) or "the gates found nothing")
    if collector.findings or any(row.is_over for row in rows):
        return 1
    return 0 if is_complete else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
