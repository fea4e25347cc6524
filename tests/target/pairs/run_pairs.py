#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same bits: builds batuta_digest for every pair of compiler and cpu in pairs.csv, runs it (on a foreign cpu by the
tree's emulator) and compares every answer with those of the first pair. Prints the pairs with their digests; where one
differs, names the first query, and the first field of its answer.

Exit status: 0 all the same; 1 a difference, or a pair that could not be built or run; 2 wrong use.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import time

import hashes

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", "..", ".."))
QUICK_EVERY = 100
PREPARED = "references.json"
RESULTS = "results.json"
LEAST_FLIGHT = 5000  # blocks of 100 steps: half a million of bodies of revolution, and as many of others
LEAST_SCENES = 6000  # four scenes, 1,500 steps each
# Toolchains that setup.sh does not install with the others: a pair without its compiler is told, and is no failure.
OPTIONAL = {"emscripten": "web", "mingw-w64": "packages"}
RUN_TIMEOUT = 7200  # s; against hanging: no verdict

Pair = collections.namedtuple("Pair", "name compiler flags toolchain port cpu board every")
Run = collections.namedtuple("Run", "pair every compiler digests records warning seconds built_in")


class Failure(Exception):
    """A pair that could not be built, run or believed."""


def read_table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [Pair(**row)._replace(every=int(row["every"])) for row in csv.DictReader(file)]


def call(words, what, log):
    """Runs a command; what it says goes into a file of its own, and its end into the failure."""
    with open(log, "w", encoding="utf-8") as file:
        result = subprocess.run(words, stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=False)
    if result.returncode != 0:
        with open(log, encoding="utf-8", errors="replace") as file:
            tail = "".join(file.readlines()[-15:])
        raise Failure(f"{what} failed (see {log}):\n{tail}")


class Trees:
    """Build trees of the pairs, build/target/<pair>. Those of a board are shared with its other tests; a pair without a
    toolchain is the host's tree as it is."""

    def __init__(self, options):
        self.build = options.build
        self.shared = options.shared
        self.host = options.host
        self.folder = os.path.join(self.build, "digest")
        os.makedirs(self.folder, exist_ok=True)

    def tree(self, pair):
        return os.path.join(self.build, "target", pair.name) if pair.toolchain else self.host

    def file(self, pair, ending):
        return os.path.join(self.folder, pair.name + ending)

    def is_configured(self, pair):
        return os.path.exists(os.path.join(self.tree(pair), "build.ninja"))

    def configure(self, pair):
        if self.is_configured(pair):
            return
        words = ["cmake", "-S", ROOT, "-B", self.tree(pair), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 f"-DCMAKE_TOOLCHAIN_FILE={toolchain_of(pair)}", f"-DBATUTA_PORT={pair.port}",
                 "-DBATUTA_WITH_DOUBLE=OFF", "-DBATUTA_BUILD_PROGRAMS=OFF"]
        if pair.board:
            words += [f"-DBATUTA_CPU={pair.cpu}", f"-DBATUTA_BOARD={pair.board}"]
        else:  # nothing else is built there: each room as one source takes half the time
            words += ["-DBATUTA_TARGET_TESTS=digest", "-DBATUTA_UNITY_ROOMS=ON"]
        if pair.compiler:
            words.append(f"-DCMAKE_CXX_COMPILER={pair.compiler}")
        if pair.flags:
            words.append(f"-DCMAKE_CXX_FLAGS_RELEASE={pair.flags}")
        call(words, f"{pair.name}: configuring", self.file(pair, ".configure.log"))

    def make(self, pair, jobs):
        """@returns what batuta_digest.json of the tree says: the command that runs the program, and the compiler."""
        self.configure(pair)
        call(["cmake", "--build", self.tree(pair), "--target", "batuta_digest", "--parallel", str(jobs)],
             f"{pair.name}: building", self.file(pair, ".build.log"))
        with open(os.path.join(self.tree(pair), "batuta_digest.json"), encoding="utf-8") as file:
            return json.load(file)

    def pack(self):
        """Packs the queries with the program of the host's tree. @returns what it says, line by line"""
        call(["cmake", "--build", self.host, "--target", "batuta_digest_pack"], "batuta_digest_pack: building",
             os.path.join(self.folder, "pack.build.log"))
        log = os.path.join(self.folder, "pack.log")
        call([os.path.join(self.host, "batuta_digest_pack"), self.shared, os.path.join(self.folder, "digest.bin")],
             "batuta_digest_pack", log)
        with open(log, encoding="utf-8") as file:
            return file.read().splitlines()

    def ask(self, command, words):
        """Runs batuta_digest beside its files, whose names stay short. @returns its lines"""
        try:
            result = subprocess.run(command + words, cwd=self.folder, stdin=subprocess.DEVNULL,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=RUN_TIMEOUT, check=False)
        except subprocess.TimeoutExpired as late:
            raise Failure(f"{command[-1]}: not done after {RUN_TIMEOUT} s") from late
        text = result.stdout.decode("utf-8", "replace")
        if result.returncode != 0:
            raise Failure(f"{command[-1]} {' '.join(words)}: exit status {result.returncode}\n{text[-1000:]}")
        return text.splitlines()

    def run(self, pair, jobs, doctor=()):
        """Builds and runs a pair with the sample that it names."""
        begin = time.monotonic()
        known = self.make(pair, jobs)
        start = time.monotonic()
        name = f"{pair.name}{'.doctored' if doctor else ''}.{pair.every}.hashes"
        lines = self.ask(known["command"], ["--hashes", name, "--every", str(pair.every), *doctor])
        seconds = time.monotonic() - start
        digests = dict(re.findall(r"^(\w+) queries \d+ every \d+ digest (\w{16})$", "\n".join(lines), re.M))
        warning = next((line for line in lines if line.startswith("warning")), "")
        return Run(pair, pair.every, known["compiler"], digests, hashes.read(os.path.join(self.folder, name)), warning,
                   seconds, start - begin)

    def show(self, pair, query, doctor=()):
        """One answer, a line a field."""
        with open(os.path.join(self.tree(pair), "batuta_digest.json"), encoding="utf-8") as file:
            command = json.load(file)["command"]
        section, index = query
        return self.ask(command, ["--every", str(pair.every), "--show", section, str(index), *doctor])


def toolchain_of(pair):
    own = os.path.join(HERE, pair.toolchain + ".cmake")
    return own if os.path.exists(own) else os.path.join(ROOT, "toolchains", pair.toolchain + ".cmake")


def missing_tool(pair, trees):
    """What a pair needs and this machine lacks; None: nothing."""
    if trees.is_configured(pair):
        return None
    with open(toolchain_of(pair), encoding="utf-8") as file:
        named = re.findall(r"(?:CMAKE_CXX_COMPILER|CMAKE_CROSSCOMPILING_EMULATOR)\s+([^\s)]+)", file.read())
    tools = [tool for tool in [pair.compiler, *named] if tool and "$" not in tool]
    return next((tool for tool in tools if shutil.which(tool) is None), None)


def describe_difference(trees, reference, other, doctor=()):
    """The first query that `other` answers differently, and a text that names it and the first field that differs."""
    query = hashes.first_difference(reference.records, other.records)
    if query is None:
        return None, "  the digests differ, but no query does"
    lines = [f"  first difference: {hashes.name_of(*query)}"]
    field = hashes.first_field(trees.show(reference.pair, query), trees.show(other.pair, query, doctor))
    if field is None:
        lines.append("  the answers are the same: what differs is whether it was asked")
    else:
        number, ours, theirs = field
        lines.append(f"  word {number} of the answer: {ours} ({reference.pair.name}), {theirs} ({other.pair.name})")
    lines.append(f"  batuta_digest --every {other.every} --show {query[0]} {query[1]} prints all of it")
    return query, "\n".join(lines)


def check_the_check(trees, reference):
    """One ulp more in one answer of each section must be found, and nothing else be named."""
    middle = {}
    for section in reference.digests:
        queries = [record for record in reference.records if record[0] == section]
        middle[section] = queries[len(queries) // 2][:2]
    for section, query in middle.items():
        doctor = ("--doctor", section, str(query[1]))
        doctored = trees.run(reference.pair, 1, doctor)
        found, text = describe_difference(trees, reference, doctored, doctor)
        changed = [name for name in hashes.SECTIONS if doctored.digests.get(name) != reference.digests.get(name)]
        if found != query or changed != [section] or "word" not in text:
            raise Failure(f"an answer falsified by one ulp ({hashes.name_of(*query)}) was not found:\n{text}")
    print(f"an answer falsified by one ulp is found and named, in each of {len(middle)} sections", flush=True)


def check_extent(reference, contents):
    """The reference has answered all that was packed."""
    text = "\n".join(contents)
    expected = {"flight": LEAST_FLIGHT, "tumbling": LEAST_FLIGHT, "scenes": LEAST_SCENES}
    for name, section in (("toc", "toc"), ("dist", "distance"), ("resp", "impulse")):
        expected[section] = sum(int(n) for n in re.findall(rf"^queries: .*\b{name}\.csv (\d+)$", text, re.M))
    expected["stepping"] = expected["toc"]
    expected["duel"] = sum(int(n) for n in re.findall(r"^bout: .* (\d+) steps$", text, re.M))
    tally = hashes.counts(reference.records)
    for section, least in expected.items():
        if tally[section] < least // reference.every:
            raise Failure(f"{section}: only {tally[section]} of {least} queries were answered")


def combined(run):
    """One number for all sections."""
    value = 14695981039346656037
    for digest in run.digests.values():
        value = ((value ^ int(digest, 16)) * 1099511628211) % (1 << 64)
    return f"{value:016x}"


def sample_of(run):
    return "all" if run.every == 1 else f"1/{run.every}"


def is_same(reference, run):
    return run.records == reference.records and run.digests == reference.digests


def judge(trees, reference, run):
    """@returns whether the pair agrees; prints its line"""
    same = is_same(reference, run)
    verdict = "same" if same else "DIFFERENT"
    print(f"{run.pair.name:22} {run.compiler:14} {sample_of(run):5} {combined(run)}  {verdict:9} built in"
          f" {run.built_in:4.0f} s, ran {run.seconds:5.1f} s", flush=True)
    if run.warning:
        print(f"  {run.warning}")
    if not same:
        print(describe_difference(trees, reference, run)[1], flush=True)
    return same and not run.warning


def result_of(reference, run):
    """What a later reader wants to know of a pair: see tests/target/all/show.py."""
    return {"pair": run.pair.name, "compiler": run.compiler, "queries": sample_of(run), "digest": combined(run),
            "verdict": "same" if is_same(reference, run) else "DIFFERENT"}


def keep_results(trees, results):
    with open(os.path.join(trees.folder, RESULTS), "w", encoding="utf-8") as file:
        json.dump(results, file, indent=1)


def print_sections(run):
    tally = hashes.counts(run.records)
    for section, digest in run.digests.items():
        print(f"  {section:12} {digest}  {tally[section]} queries")


def compare_all(trees, references, pairs, jobs):
    """Two pairs at a time where there are two processors. @returns the names of those that agree, and all results"""
    good, results = set(), []
    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        runs = {pool.submit(trees.run, pair, 1): pair for pair in pairs}
        for future in concurrent.futures.as_completed(runs):
            try:
                run = future.result()
                results.append(result_of(references[run.every], run))
                if judge(trees, references[run.every], run):
                    good.add(run.pair.name)
            except (Failure, OSError) as failure:
                print(f"{runs[future].name:22} FAILED: {failure}", flush=True)
                results.append({"pair": runs[future].name, "verdict": "FAILED"})
    return good, results


def prepare(trees, pair, samples, jobs):
    """Packs the queries and runs the first pair with every sample that is in use. @returns its runs by sample"""
    contents = trees.pack()
    print("\n".join(contents), flush=True)
    references = {every: trees.run(pair._replace(every=every), jobs) for every in sorted(samples)}
    for reference in references.values():
        check_extent(reference, contents)
    print_sections(references[min(samples)])
    check_the_check(trees, references[max(samples)])
    known = {every: run._replace(pair=None, records=None)._asdict() for every, run in references.items()}
    with open(os.path.join(trees.folder, PREPARED), "w", encoding="utf-8") as file:
        json.dump(known, file)
    return references


def prepared(trees, pair):
    """What an earlier prepare() left, for a run that only adds pairs."""
    with open(os.path.join(trees.folder, PREPARED), encoding="utf-8") as file:
        known = {int(every): fields for every, fields in json.load(file).items()}
    return {every: Run(**{**fields, "pair": pair._replace(every=every),
                          "records": hashes.read(trees.file(pair, f".{every}.hashes"))})
            for every, fields in known.items()}


def run_all(table, options):
    """@returns whether all pairs are as they have to be: the same, or, if a fault is planted in them, not the same"""
    trees = Trees(options)
    keeps_results = not (options.prepare or options.prepared or options.planted)
    if keeps_results:
        keep_results(trees, [])  # nothing of an earlier run outlives one that fails
    wanted = [pair for pair in table[1:] if not options.pairs or pair.name in options.pairs]
    if options.prepared:
        references = prepared(trees, table[0])
    else:
        compared = table if options.prepare else [table[0], *wanted]
        references = prepare(trees, table[0], {pair.every for pair in compared}, options.jobs)
        for reference in references.values():
            judge(trees, reference, reference)
    if options.prepare:
        return True
    lacking = {pair: missing_tool(pair, trees) for pair in wanted}
    for pair, tool in lacking.items():
        if tool:
            word = OPTIONAL.get(pair.toolchain, "target")
            print(f"{pair.name:22} not run: there is no {tool} (sh toolchains/setup.sh {word} installs it)")
    runnable = [pair for pair in wanted if not lacking[pair]]
    same, results = compare_all(trees, references, runnable, options.jobs)
    if keeps_results:
        lacked = [{"pair": pair.name, "verdict": f"not run: no {tool}"} for pair, tool in lacking.items() if tool]
        keep_results(trees, [result_of(run, run) for run in references.values()] + results + lacked)
    # What only the night installs may be missing by day.
    may_lack = () if options.every == 1 else OPTIONAL
    complete = options.allow_missing or all(pair in runnable or pair.toolchain in may_lack for pair in wanted)
    return complete and len(same) == (0 if options.planted else len(runnable))


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", help="only these, comma between (the first of the table always runs)")
    parser.add_argument("--prepare", action="store_true", help="only pack the queries and run the first pair")
    parser.add_argument("--prepared", action="store_true", help="that was done before: only compare pairs with it")
    parser.add_argument("--planted", action="store_true",
                        help="the pairs of planted.csv instead, each of which must be found wrong")
    parser.add_argument("--every", type=int, metavar="K",
                        help="every K-th query, sequences K times shorter; 1: all (default: as the table says)")
    parser.add_argument("--full", action="store_const", dest="every", const=1, help="the same as --every 1")
    parser.add_argument("--quick", action="store_const", dest="every", const=QUICK_EVERY, help=f"--every {QUICK_EVERY}")
    parser.add_argument("--build", default=os.path.join(ROOT, "build"), help="default: build")
    parser.add_argument("--host", help="tree with batuta_digest_pack; default: build/host")
    parser.add_argument("--shared", default=os.path.join(ROOT, "..", "shared"), help="folder with vectors, recordings")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--allow-missing", action="store_true", help="a pair whose compiler is missing is no failure")
    options = parser.parse_args()
    options.pairs = options.pairs.split(",") if options.pairs else []
    options.host = options.host or os.path.join(options.build, "host")
    return parser, options


def main():
    parser, options = read_arguments()
    table = read_table(os.path.join(HERE, "planted.csv" if options.planted else "pairs.csv"))
    unknown = set(options.pairs) - {pair.name for pair in table}
    if unknown:
        parser.error(f"no such pair: {', '.join(sorted(unknown))}")
    if options.every is not None:
        if options.every < 1:
            parser.error("--every: at least 1")
        table = [pair._replace(every=options.every) for pair in table]
    begin = time.monotonic()
    try:
        good = run_all(table, options)
    except Failure as failure:
        print(f"FAILED: {failure}")
        good = False
    wish = "every planted fault is found" if options.planted else "all the same"
    print(f"{wish if good else 'NOT ' + wish}; {time.monotonic() - begin:.0f} s")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
