#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clang-format, cppcheck and clang-tidy over the project's own files, those of the boards with the flags of the cross
build. Ends with 1 on any finding, where a source is in no compile database, and also where a tool does not report what
was planted in tests/static/canary: a tool that finds nothing may be one that looks at nothing."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

FORMATTED = ("include", "src", "port", "examples", "tests")
ANALYZED = ("src", "port", "examples", "tests/support")
CANARIES = ("tests/static/canary",)
STEPS = ("format", "database", "sources", "canaries", "cppcheck", "tidy")
SOURCES = ("src", "port", "examples", "tests")  # of which every .cpp is in a compile database, but for:
IN_NO_DATABASE = {
    "port/programs/live/open_sdl_absent.cpp": "is compiled where SDL is missing",
    "port/programs/duel/view/view_absent.cpp": "is compiled where SDL is missing",
    "port/platforms/rp2040/trap.cpp": "is compiled inside the Pico SDK",
    "port/platforms/rp2040/usb_stick/": "is compiled inside the Pico SDK, and for the cortex-m0plus",
    "tests/compile_fail/cases/": "must not compile",
    "tests/port/rp2040/absent_pico.cpp": "is compiled for the cortex-m0plus",
    "tests/consumer/project/": "projects of their own, built by a test",
    "tests/measure/compile_time/": "are compiled by the test that times them",
    "tests/packages/arduino/core/": "a core of Arduino for the test of the archive, built by it",
    "tests/port/kernel/": "is compiled where toolchains/setup.sh kernel has been",
}
# Configured, not built, for what is compiled for a board only. Their databases say what the host's does not know.
CROSS_COMPILER = "arm-none-eabi-g++"
CROSS_PRESETS = ("cortex-m4f", "stm32f405")
CROSS_ONLY = ("port/platforms/cortex_m/", "port/platforms/mps2/", "port/platforms/stm32f405/", "tests/target/", "tests/support/heap_trap_of_board.cpp",
              "tests/static/canary/target_")
GCC_ONLY = re.compile(r"-fcallgraph-info\S*|-fno-tree-loop-distribute-patterns|--param[ =]\S+")  # flags
CROSS_TARGET = "--target=armv7em-none-eabi"
CROSS_PLATFORM = "--platform=arm32-wchar_t4"
# Left out, with the reason:
SUPPRESSED = [
    "CastIntegerToAddressAtReturn",  # C++ does not compile that; cppcheck 2.10 takes std::array<const char*, N> for it
    "unusedPrivateFunction",         # wrong for class templates, whose use cppcheck does not see
    "duplInheritedMember",           # Enlarged and RefusedScene hide constants of the scene that they stand for
    "shadowFunction",                # a variable named after the function that gave it; -Wshadow tells of variables
    "useStlAlgorithm",               # a loop with its bound beside it is the house's form
]
CPPCHECK = ["cppcheck", "--enable=warning,style,performance,portability", "--inline-suppr", "--error-exitcode=1",
            "--std=c++17", "--quiet", "--template={file}:{line}: {severity}: {message} [{id}]",
            *(f"--suppress={name}" for name in SUPPRESSED)]
# Without it the analyzer passes over what a bundle includes, and says nothing of it; the canary's leak would tell.
INCLUDED_TOO = ("-Xclang", "-analyzer-opt-analyze-headers")
# Of the graph that clang's analyzer makes of a function. Some functions of a World fill any; its own limit is 225,000, which the
# target analyze-deep has, for the night.
MAX_NODES = 50_000
INCLUDED = '#include "{name}"  // NOLINT(bugprone-suspicious-include)\n'  # a file of a bundle
INCLUDED_PROGRAM = f"#define main main_{{number}}  // NOLINT\n{INCLUDED}#undef main\n"  # one bundle may hold several
NO_CODE = re.compile(r"-O\S|-f(function|data)-sections|-fno-math-errno")  # changes code, and nothing that clang-tidy looks at
BUNDLE_BYTES = 100_000  # of sources: fewer bundles read headers less often, more of them keep all cores at work
LONGEST = 5  # units of clang-tidy, whose times are told
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def say(text):
    print(f"-- {text}", flush=True)


def files_in(source, folders, suffixes):
    return sorted(p for folder in folders for p in (source / folder).rglob("*") if p.suffix in suffixes)


def run(command):
    """(exit code, output without colours) of a command."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, COLOUR.sub("", done.stdout)


def search_path(command):
    """Where a compiler finds its standard library, which clang does not know: without the compiler's own headers, in
    whose place clang has some."""
    words = [word for word in shlex.split(command) if word.startswith("-m")]
    done = subprocess.run([shlex.split(command)[0], *words, "-E", "-x", "c++", os.devnull, "-v"], capture_output=True,
                          text=True, check=True)
    listed = done.stderr.partition("search starts here:\n#include <...>")[2].splitlines()[1:]
    folders = [os.path.normpath(line.strip()) for line in listed[:listed.index("End of search list.")]]
    return [folder for folder in folders if not re.search(r"/lib/gcc/[^/]+/[^/]+/include(-fixed)?$", folder)]


def for_clang(command):
    """A cross compiler's command as clang understands it."""
    kept = shlex.split(GCC_ONLY.sub("", command))[1:]
    system = [word for folder in search_path(command) for word in ("-isystem", folder)]
    return shlex.join(["clang++", CROSS_TARGET, "-nostdlibinc", *kept[:-4], *system, *kept[-4:]])  # -o, -c at the end


def included(name, number):
    """What a bundle has of a file."""
    is_program = re.search(r"^int main\(", pathlib.Path(name).read_text(encoding="utf-8"), re.M)
    return (INCLUDED_PROGRAM if is_program else INCLUDED).format(name=name, number=number)


def same_for_clang_tidy(flags):
    """Flags but for those of code that nobody generates here, in one order."""
    kept = [word for word in shlex.split(flags)[1:] if not NO_CODE.fullmatch(word)]
    return tuple(sorted(word if not word.startswith("-I") else f"-I{os.path.normpath(word[2:])}" for word in kept))


def filled(group):
    """What is compiled alike, in bundles of at most BUNDLE_BYTES; one file may be larger."""
    bundle = []
    for name in sorted(group):
        if bundle and size_of([*bundle, name]) > BUNDLE_BYTES:
            yield bundle
            bundle = []
        bundle.append(name)
    yield bundle


def size_of(bundle):
    """Bytes of its sources."""
    return sum(map(os.path.getsize, bundle))


class Analysis:
    def __init__(self, source, build, under="", max_nodes=MAX_NODES):
        self.source = source
        self.build = build
        self.under = str(source / under)  # what is analysed begins with it
        self.limits = ("-Xclang", "-analyzer-config", "-Xclang", f"max-nodes={max_nodes}")
        self.failed = []
        self.units = json.loads((build / "compile_commands.json").read_text())
        known = {unit["file"] for unit in self.units}
        # Only what no host compiles: a unit is analysed once, with the flags of the machine it is tested on.
        self.cross = [unit for unit in self.cross_units() if unit["file"] not in known]
        self.cross_files = {unit["file"] for unit in self.cross}
        self.flags = {}  # file: what clang compiles it with
        self.database = self.write_database()

    def cross_units(self):
        if shutil.which(CROSS_COMPILER) is None:
            say(f"LEFT OUT, for there is no {CROSS_COMPILER} (toolchains/setup.sh target): {', '.join(CROSS_ONLY)}")
            return []
        units = {}
        for preset in CROSS_PRESETS:
            tree = self.build / preset
            words = ["cmake", "--preset", preset, "-B", str(tree)]
            done = subprocess.run(words, cwd=self.source, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                self.fail(f"configuring {preset}", done.stdout + done.stderr)
                continue
            found = json.loads((tree / "compile_commands.json").read_text())
            units.update((unit["file"], unit) for unit in found if unit["file"].startswith(f"{self.source}{os.sep}")
                         and not unit["file"].startswith(str(self.build)))
        return list(units.values())

    def write_database(self):
        """A compile database of the files to look at only: generated files need not exist, and are nobody's to fix.
        In `cross`, for cppcheck, those of the boards."""
        folder = self.build / "analysis"
        (folder / "cross").mkdir(parents=True, exist_ok=True)
        wanted = set(self.units_in(ANALYZED)) | {str(p) for p in files_in(self.source, CANARIES, (".cpp",))}
        units = {unit["file"]: dict(unit, command=GCC_ONLY.sub("", unit["command"]))
                 for unit in self.units if unit["file"] in wanted}  # each file once
        boards = [unit for unit in self.cross if unit["file"] in wanted]
        (folder / "cross" / "compile_commands.json").write_text(json.dumps(boards, indent=1))
        units.update((unit["file"], dict(unit, command=for_clang(unit["command"]))) for unit in boards)
        self.flags = {name: re.sub(r" -o \S+ -c \S+$", "", unit["command"]) for name, unit in units.items()}
        (folder / "compile_commands.json").write_text(json.dumps(list(units.values()), indent=1))
        return folder

    def fail(self, what, output=""):
        print(output, end="" if output.endswith("\n") else "\n")
        say(f"FAILED: {what}")
        self.failed.append(what)

    def units_in(self, folders):
        """Files of the compile databases in these folders, each once; tests, all macros, are left out."""
        roots = tuple(str(self.source / folder) + os.sep for folder in folders)
        files = {unit["file"] for unit in self.units} | self.cross_files
        return sorted(name for name in files if name.startswith(roots) and name.startswith(self.under)
                      and not name.endswith("_test.cpp"))

    def sources(self):
        """Every .cpp of ours: what git tracks, or would."""
        words = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *SOURCES]
        done = subprocess.run(words, cwd=self.source, capture_output=True, text=True, check=False)
        names = done.stdout.split("\0") if done.returncode == 0 else \
            [str(path.relative_to(self.source)) for path in files_in(self.source, SOURCES, (".cpp",))]
        return sorted(name for name in names if name.endswith(".cpp") and (self.source / name).exists())

    def check_sources(self):
        """Without the cross compiler what only it compiles is left out, and has been told."""
        names = self.sources()
        listed = {unit["file"] for unit in self.units} | self.cross_files
        excused = tuple(IN_NO_DATABASE) + (() if shutil.which(CROSS_COMPILER) else CROSS_ONLY)
        say(f"sources: {len(names)}, of which {len(self.units_in(ANALYZED))} are analysed")
        lost = [name for name in names if str(self.source / name) not in listed and not name.startswith(excused)]
        if lost or not names:
            self.fail("sources", "\n".join(f"{name}: in no compile database, so nothing analyses it" for name in lost))

    def check_format(self):
        files = files_in(self.source, FORMATTED, (".hpp", ".cpp"))
        say(f"clang-format: {len(files)} files")
        code, output = run(["clang-format", "--dry-run", "-Werror", *map(str, files)])
        if code != 0:
            wrong = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", output, re.M)))
            self.fail("clang-format", "\n".join(f"{name}: not as clang-format writes it" for name in wrong))

    def check_database(self):
        """With Eigen as a plain include folder cppcheck 2.10 gives up silently on every file that includes it."""
        say("compile database: Eigen is a system include")
        plain = [unit["file"] for unit in self.units if re.search(r"-I\s*\S*eigen3", unit["command"])]
        system = [unit for unit in self.units if re.search(r"-isystem\s+\S*eigen3", unit["command"])]
        if plain or not system:
            self.fail("compile database", "\n".join(plain) or "no unit has Eigen")

    def check_canaries(self):
        for canary in files_in(self.source, CANARIES, (".cpp",)):
            say(f"canary {canary.name}")
            expected = set(re.findall(r"// expect: (\S+)", canary.read_text()))
            if canary.name.startswith("target_") and not self.cross:
                say("left out, as said above")
                continue
            # Two for clang-tidy, so that they are a bundle as nearly all units are: see INCLUDED_TOO.
            code, output = self.cppcheck([canary]) if "cppcheck" in canary.name else \
                self.tidy([canary, canary.with_name(canary.name.replace("tidy", "cppcheck"))])
            missing = {name for name in expected if f"[{name}" not in output}
            if code == 0 or missing or not expected or "clang-diagnostic-error" in output:
                self.fail(f"{canary.name}: not reported: {', '.join(sorted(missing)) or 'by exit code'}", output)

    def cppcheck(self, files):
        """Those of the boards with the sizes of theirs."""
        names = set(map(str, files))
        worst, told = 0, ""
        for folder, wanted, platform in ((self.database, names - self.cross_files, []),
                                         (self.database / "cross", names & self.cross_files, [CROSS_PLATFORM])):
            if not wanted:
                continue
            code, output = run([*CPPCHECK, *platform, f"-j{os.cpu_count() or 1}",
                                f"--project={folder / 'compile_commands.json'}",
                                *(f"--file-filter={name}" for name in sorted(wanted))])
            worst, told = max(worst, code), told + output
        return worst, told

    def tidy(self, files):
        """Many units as one source file: clang-tidy spends nine tenths of its time in the headers of Eigen and the library,
        which a bundle reads once. The largest comes first, or one core waits for another's last one."""
        groups = {}  # flags without what they do not change for clang-tidy, and a folder: files
        for name in map(str, files):
            groups.setdefault((same_for_clang_tidy(self.flags[name]), self.folder_of(name)), []).append(name)
        bundles = sorted((bundle for group in groups.values() for bundle in filled(group)), key=size_of, reverse=True)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            looked = [look for looks in pool.map(self.look_at, bundles) for look in looks]
        for seconds, names, _, _ in sorted(looked, reverse=True)[:LONGEST]:
            say(f"{seconds:.0f} s for {len(names)} from {pathlib.Path(names[0]).relative_to(self.source)}")
        return max((code for _, _, code, _ in looked), default=0), "".join(output for _, _, _, output in looked)

    def folder_of(self, name):
        """What a file may share a bundle with: the library is one source for users, too; what ports have in common may stand in
        each of them, as symbols of a linker script do."""
        room = str(self.source / "src") + os.sep
        return room if name.startswith(room) else os.path.dirname(name)

    def look_at(self, names):
        """[(seconds, names, exit code, output)] of a bundle. Of one that does not compile, as where two files use one name for
        different things, each file is looked at alone."""
        folder = self.database / "bundles"
        folder.mkdir(exist_ok=True)
        stem = "_".join(pathlib.Path(names[0]).relative_to(self.source).with_suffix("").parts)
        bundle = folder / f"{stem}_{len(names)}.cpp"
        bundle.write_text("".join(included(name, number) for number, name in enumerate(names)))
        start = time.monotonic()
        looked_at, more = (str(bundle), INCLUDED_TOO) if len(names) > 1 else (names[0], ())  # alone it is its own main file
        code, output = run(["clang-tidy", "--quiet", looked_at, "--", *shlex.split(self.flags[names[0]])[1:], *self.limits, *more])
        if len(names) > 1 and "[clang-diagnostic-error]" in output:
            return [look for name in names for look in self.look_at([name])]
        return [(time.monotonic() - start, names, code, output)]

    def check_cppcheck(self):
        units = self.units_in(ANALYZED)
        say(f"cppcheck: {len(units)} units")
        code, output = self.cppcheck(units)
        if code != 0 or not units:
            self.fail("cppcheck", output)

    def check_tidy(self):
        units = self.units_in(ANALYZED)
        say(f"clang-tidy: {len(units)} units")
        code, output = self.tidy(units)
        findings = sorted(set(re.findall(r"^/\S+:\d+:\d+: (?:error|warning): .*$", output, re.M)))
        if code != 0 or not units:
            self.fail("clang-tidy", "\n".join(findings) or output)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--only", choices=STEPS)
    parser.add_argument("--under", default="", help="analyse only the sources whose names begin so, as port/platforms/mps2")
    parser.add_argument("--max-nodes", type=int, default=MAX_NODES, help="of a function's graph, for clang's analyzer")
    options = parser.parse_args()
    for tool in ("clang-format", "cppcheck", "clang-tidy"):
        if shutil.which(tool) is None:
            print(f"analyze: {tool} is missing: run toolchains/setup.sh host", file=sys.stderr)
            return 2

    begin = time.monotonic()
    analysis = Analysis(options.source.resolve(), options.build.resolve(), options.under, options.max_nodes)
    for step in STEPS:
        if options.only in (None, step):
            start = time.monotonic()
            getattr(analysis, f"check_{step}")()
            say(f"{step}: {time.monotonic() - start:.0f} s")
    say(f"{time.monotonic() - begin:.0f} s in all")
    say(f"analyze: failed: {', '.join(analysis.failed)}" if analysis.failed else "analyze: no findings")
    return 1 if analysis.failed else 0


if __name__ == "__main__":
    sys.exit(main())
