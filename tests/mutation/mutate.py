#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants mutations in the library, one at a time in a copy of the tree, and tells which of them the tests kill.

  python3 tests/mutation/mutate.py --count 240 --seed 1        a sample, as many of each room
  python3 tests/mutation/mutate.py --room response --count 0   every mutation of a room: hours
  python3 tests/mutation/mutate.py --list --room core          what there is to plant

A mutation first meets the unit tests of its own room (one that very many of these read: kept states, which are one
file), then, if it lives, stronger tests. It is killed where a test
fails, the program ends by a trap, or it hangs; one that does not compile is not counted. Results stay in the folder,
and are not asked for again, until --fresh; --again asks for those that lived, after tests were added. Ends with 1 if a
mutation lives that survivors.json gives no reason for, or fewer of a room are killed than --at-least per cent. On an idle core a
mutation of a source costs some 5 s, of a header that tests are made of 10 to 30 s."""
import argparse
import collections
import itertools
import json
import pathlib
import random
import signal
import sys
import time

import mutations
from workbench import Bench, NotReady

HERE = pathlib.Path(__file__).resolve().parent
# The tests of a room, and those that a mutation meets which they leave alive. `fixtures` goes on with kept states of
# every ready-made scene, to the last bit, and is one file: what changes an answer at all seldom gets past it.
STRONGER = {
    "core": ["fixtures", "port", "link", "world", "fencing"],
    "port": ["host_devices"],
    "geometry": ["fixtures", "detection", "response", "vectors"],
    "mechanics": ["fixtures", "response", "detection", "vectors"],
    "detection": ["fixtures", "vectors", "world", "fencing"],
    "response": ["fixtures", "vectors", "world", "world_many", "stability"],
    "world": ["fixtures", "world_many", "fencing", "stability"],
    "fencing": ["fixtures", "fight", "duel_program"],
    "control": ["fencing"],
    "record": ["duel_program"],
    "c": [],
    "haptics": ["haptic_stability", "extreme"],
}
MOST_UNITS = 12      # a header that more files read is not followed beyond its room
KILLED, STRONGLY_KILLED, ALIVE, NO_MUTANT = "killed", "killed by stronger tests", "alive", "does not compile"


def program(name):
    return f"batuta_test_{name}"


def room_of(file):
    parts = pathlib.PurePath(file).parts
    return parts[1] if parts[0] == "src" else parts[2]


def files_of(source, rooms):
    for base in ("src", "include/batuta"):
        for path in sorted((source / base).rglob("*.?pp")):
            file = str(path.relative_to(source))
            if room_of(file) in rooms:
                yield file


def all_mutations(source, rooms):
    """{name: mutation}; lines of a file that read the same count once."""
    found = {}
    for file in files_of(source, rooms):
        text = (source / file).read_text()
        found.update({mutations.name_of(text, m): m for m in mutations.mutations_of(file, text)})
    return found


class Trial:
    """One mutation in the tree of the bench."""

    def __init__(self, bench, mutation, quick=False):
        self.bench = bench
        self.mutation = mutation
        self.stronger = [] if quick else STRONGER[room_of(mutation.file)]
        self.units = bench.units_reading(mutation.file)
        self.objects = {}  # unit of src: its mutated object

    def verdict(self):
        """(what became of it, what killed it)"""
        path = self.bench.tree / self.mutation.file
        text = path.read_text()
        path.write_text(mutations.apply(text, self.mutation))
        try:
            return self.meet_all()
        finally:
            path.write_text(text)

    def meet_all(self):
        room = room_of(self.mutation.file)
        if not self.compile_units(room):
            return NO_MUTANT, ""
        if "fixtures" in self.stronger and len(self.tests_of(room)) > MOST_UNITS:  # one file before very many
            killer = self.meet("fixtures")
            if killer:
                return STRONGLY_KILLED, killer
        killer = self.meet(room)
        if killer is None:
            return NO_MUTANT, ""
        if killer:
            return KILLED, killer
        return self.meet_stronger()

    def meet_stronger(self):
        if self.stronger and len(self.units_of("src")) <= MOST_UNITS:
            self.compile_units(None)
        for name in self.stronger:
            killer = self.meet(name)
            if killer:
                return STRONGLY_KILLED, killer
        return ALIVE, ""

    def units_of(self, folder):
        return [unit for unit in self.units if unit.startswith(f"{folder}/")]

    def tests_of(self, name):
        """The files of a program of tests that read the mutated one."""
        return [unit for unit in self.units_of("tests") if f"/{program(name)}.dir/" in self.bench.object_of(unit)]

    def compile_units(self, room):
        """The library's files that read the mutated one: those of the room, or all."""
        for unit in self.units_of("src"):
            if unit not in self.objects and room in (None, room_of(unit)):
                self.objects[unit] = self.bench.compile(unit, self.mutation.file)
        return None not in self.objects.values()

    def meet(self, name):
        """The name of the test that kills; "": none does; None: there is no such program."""
        tests = self.tests_of(name)
        if len(tests) > MOST_UNITS and name != room_of(self.mutation.file):
            tests = []
        if not tests:
            return self.run(name, self.objects)
        stem = pathlib.PurePath(self.mutation.file).stem
        targets = {}
        for test in sorted(tests, key=lambda unit: (not pathlib.PurePath(unit).stem.startswith(stem), unit)):
            targets[test] = self.bench.compile(test, self.mutation.file)
            killer = self.run(name, {test: targets[test], **self.objects}, test) if targets[test] else None
            if killer != "":
                return killer
        return self.run(name, {**targets, **self.objects})  # with the tests that read the library alone

    def run(self, name, objects, only_test=None):
        patience = self.bench.patience_with(program(name))  # first: it may have to link the program as it is
        executable = self.bench.link(program(name), objects, only_test)
        if executable is None:
            return None
        result = self.bench.run(executable, patience)
        return "" if result.passed else result.killer()


class Book:
    """Results, kept between runs: {name of the mutation: [verdict, killer]}, of what can still be planted."""

    def __init__(self, path, fresh, there):
        self.path = path
        kept = json.loads(path.read_text()) if path.is_file() and not fresh else {}
        self.results = {name: result for name, result in kept.items() if name in there}

    def add(self, name, result):
        self.results[name] = list(result)
        self.path.write_text(json.dumps(self.results, indent=1))


def reasons(path):
    """{name of a mutation, or the beginning of its name: why it may live}"""
    return {name: entry["reason"] for entry in json.loads(path.read_text()) for name in entry["mutations"]}


def reason_for(name, known):
    return next((why for start, why in known.items() if name.startswith(start)), None)


def share(tally):
    tried = sum(count for verdict, count in tally.items() if verdict != NO_MUTANT)
    return 100.0 * (tally[KILLED] + tally[STRONGLY_KILLED]) / tried if tried else 100.0


def tallies(results):
    """{room: Counter of verdicts}, and of all rooms together."""
    table = collections.defaultdict(collections.Counter)
    for name, (verdict, _) in results.items():
        for room in (room_of(name.split(":")[0]), "all"):
            table[room][verdict] += 1
    return table


def least_share(results):
    """Of the rooms."""
    return min((share(tally) for tally in tallies(results).values()), default=100.0)


def report(results, known):
    """Lines for a reader: the table, then each that lives."""
    lines = ["| room | planted | do not compile | killed by the room's tests | by stronger ones | live | killed, % |",
             "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"]
    for room, tally in sorted(tallies(results).items(), key=lambda item: (item[0] == "all", item[0])):
        counts = [sum(tally.values()), *(tally[verdict] for verdict in (NO_MUTANT, KILLED, STRONGLY_KILLED, ALIVE))]
        lines.append(f"| {room} | {' | '.join(map(str, counts))} | {share(tally):.1f} |")
    for name in sorted(name for name, (verdict, _) in results.items() if verdict == ALIVE):
        lines.append(f"- {name}\n  {reason_for(name, known) or 'NO REASON GIVEN'}")
    return lines


def options(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = HERE.parent.parent
    parser.add_argument("--room", action="append", choices=STRONGER, help="repeat for several; default: all")
    parser.add_argument("--only", default="", help="what the name of a file begins with, such as src/core/pool")
    parser.add_argument("--count", type=int, default=240, help="size of the sample; 0: all (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the sample (%(default)s)")
    parser.add_argument("--minutes", type=float, default=1e9, help="starts no other mutation after that")
    parser.add_argument("--build", type=pathlib.Path, default=source / "build" / "host", help="made up to date")
    parser.add_argument("--folder", type=pathlib.Path, default=source / "build" / "mutation", help="of copies, results")
    parser.add_argument("--fresh", action="store_true", help="forget the results of earlier runs")
    parser.add_argument("--again", action="store_true", help="ask for those that lived, and no others")
    parser.add_argument("--quick", action="store_true", help="leave the stronger tests to a later --again")
    parser.add_argument("--keep", action="store_true", help="use the copies of the run before")
    parser.add_argument("--at-least", type=float, default=90.0, help="share of each room that must be killed, %% (%(default)s)")
    parser.add_argument("--list", action="store_true", help="only print the names of the sample")
    chosen = parser.parse_args(arguments)
    chosen.source = source
    chosen.room = chosen.room or list(STRONGER)
    return chosen


def sample(found, chosen):
    """Names: as many of each room, its headers included, or all that a room has; the rooms take turns, so that a sample
    that time cuts short is even, too."""
    if chosen.count == 0:
        return sorted(found)
    rooms = collections.defaultdict(list)
    for name, mutation in sorted(found.items()):
        rooms[room_of(mutation.file)].append(name)
    each = -(-chosen.count // max(len(rooms), 1))
    drawn = [random.Random(f"{chosen.seed} {room}").sample(names, min(each, len(names)))
             for room, names in sorted(rooms.items())]
    turns = itertools.zip_longest(*drawn)
    return [name for turn in turns for name in turn if name is not None][:chosen.count]


def prepare(chosen):
    bench = Bench(chosen.source, chosen.build.resolve(), chosen.folder.resolve())
    names = sorted({name for room in chosen.room for name in [room, *STRONGER[room]]})
    bench.set_up([program(name) for name in names], chosen.keep)
    return bench


def plant_all(bench, mutants, book, chosen):
    """@param mutants {name: mutation}"""
    end = time.monotonic() + 60 * chosen.minutes
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("stopped"))  # so that the tree is put right
    for number, (name, mutation) in enumerate(mutants.items(), 1):
        if time.monotonic() > end:
            break
        begin = time.monotonic()
        result = Trial(bench, mutation, chosen.quick).verdict()
        book.add(name, result)
        took = time.monotonic() - begin
        print(f"{number}/{len(mutants)} {took:.0f} s: {result[0]} ({result[1]}): {name}", flush=True)


def main(arguments):
    chosen = options(arguments)
    tree = chosen.folder / "tree" if chosen.keep else chosen.source
    there = all_mutations(tree, list(STRONGER))
    found = {name: m for name, m in there.items() if room_of(m.file) in chosen.room and m.file.startswith(chosen.only)}
    if chosen.list:
        print(*sample(found, chosen), sep="\n")
        return 0
    chosen.folder.mkdir(parents=True, exist_ok=True)
    book = Book(chosen.folder / "results.json", chosen.fresh, there)
    lived = [name for name, (verdict, _) in book.results.items() if verdict == ALIVE and name in found]
    names = lived if chosen.again else [name for name in sample(found, chosen) if name not in book.results]
    if names:
        try:
            plant_all(prepare(chosen), {name: found[name] for name in names}, book, chosen)
        except NotReady as reason:
            print(reason)
            return 2
    known = reasons(HERE / "survivors.json")
    lines = report(book.results, known)
    (chosen.folder / "report.md").write_text("\n".join(lines) + "\n")
    print(*lines, sep="\n")
    unexplained = [n for n, (verdict, _) in book.results.items() if verdict == ALIVE and not reason_for(n, known)]
    return 1 if unexplained or least_share(book.results) < chosen.at_least else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
