#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""clang-format, cppcheck and clang-tidy over the project's own files. Ends with 1 on any finding, and also where a
tool does not report what was planted in tests/static/canary: a tool that finds nothing may be one that looks at nothing."""

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

FORMATTED = ("include", "src", "port", "tests")
ANALYZED = ("src", "port", "tests/support")
CANARIES = ("tests/static/canary",)
# Left out, with the reason:
SUPPRESSED = [
    "CastIntegerToAddressAtReturn",  # C++ does not compile that; cppcheck 2.10 takes std::array<const char*, N> for it
    "unusedPrivateFunction",         # wrong for class templates, whose use cppcheck does not see
    "duplInheritedMember",           # a scene hides the constants of batuta::Scene: that is how scenes are made
    "shadowFunction",                # a variable named after the function that gave it; -Wshadow tells of variables
    "useStlAlgorithm",               # a loop with its bound beside it is the house's form
]
CPPCHECK = ["cppcheck", "--enable=warning,style,performance,portability", "--inline-suppr", "--error-exitcode=1",
            "--std=c++17", "--quiet", "--template={file}:{line}: {severity}: {message} [{id}]",
            *(f"--suppress={name}" for name in SUPPRESSED)]
# Without it the analyzer passes over what a bundle includes, and says nothing of it; the canary's leak would tell.
INCLUDED_TOO = " -Xclang -analyzer-opt-analyze-headers"
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def say(text):
    print(f"-- {text}", flush=True)


def files_in(source, folders, suffixes):
    return sorted(p for folder in folders for p in (source / folder).rglob("*") if p.suffix in suffixes)


def run(command):
    """(exit code, output without colours) of a command."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, COLOUR.sub("", done.stdout)


class Analysis:
    def __init__(self, source, build):
        self.source = source
        self.build = build
        self.failed = []
        self.units = json.loads((build / "compile_commands.json").read_text())
        self.bundles = {}   # path of the bundle: its files
        self.commands = {}  # path of the bundle: how it is compiled
        self.database = self.write_database()

    def write_database(self):
        """A compile database of the files to look at only: generated files need not exist, and are nobody's to fix."""
        folder = self.build / "analysis"
        folder.mkdir(exist_ok=True)
        wanted = set(self.units_in(ANALYZED)) | {str(p) for p in files_in(self.source, CANARIES, (".cpp",))}
        units = {unit["file"]: unit for unit in self.units if unit["file"] in wanted}  # each file once
        entries = [*units.values(), *self.write_bundles(folder, units.values())]
        (folder / "compile_commands.json").write_text(json.dumps(entries, indent=1))
        return folder

    def write_bundles(self, folder, units):
        """One source file for all units of a folder with the same flags. clang-tidy spends nine tenths of its time in
        the headers of Eigen and the library, which a bundle reads once."""
        bundles = {}
        for unit in units:
            flags = re.sub(r" -o \S+ -c \S+$", "", unit["command"])
            bundles.setdefault((pathlib.Path(unit["file"]).parent, flags), []).append(unit)
        for number, ((parent, flags), members) in enumerate(sorted(bundles.items())):
            names = sorted(unit["file"] for unit in members)
            bundle = folder / f"{number:02}_{'_'.join(parent.relative_to(self.source).parts)}.cpp"
            bundle.write_text("".join(f'#include "{name}"  // NOLINT(bugprone-suspicious-include)\n' for name in names))
            self.bundles[bundle] = names
            self.commands[bundle] = f"{flags} -c {bundle}"
            yield {"directory": str(self.build), "file": str(bundle), "command": self.commands[bundle] + INCLUDED_TOO}

    def bundled(self, names):
        """What to hand to clang-tidy for these files: their bundle, or the file itself where it is alone in one. A
        bundle whose files use one name for different things does not compile: they are then taken one by one."""
        wanted = {str(name) for name in names}
        bundles = {bundle: members for bundle, members in self.bundles.items() if wanted.intersection(members)}
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            fit = dict(zip(bundles, pool.map(self.compiles, bundles)))
        return [name for bundle, members in bundles.items()
                for name in ([str(bundle)] if fit[bundle] else sorted(wanted.intersection(members)))]

    def compiles(self, bundle):
        if len(self.bundles[bundle]) == 1:
            return False
        command = [*shlex.split(self.commands[bundle]), "-w", "-fsyntax-only"]
        return subprocess.run(command, cwd=self.build, capture_output=True, check=False).returncode == 0

    def fail(self, what, output=""):
        print(output, end="" if output.endswith("\n") else "\n")
        say(f"FAILED: {what}")
        self.failed.append(what)

    def units_in(self, folders):
        """Files of the compile database in these folders, each once; tests, all macros, are left out."""
        roots = tuple(str(self.source / folder) + os.sep for folder in folders)
        files = {unit["file"] for unit in self.units}
        return sorted(name for name in files if name.startswith(roots) and not name.endswith("_test.cpp"))

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
            command = self.cppcheck([canary]) if "cppcheck" in canary.name else self.tidy([canary])
            code, output = run(command)
            missing = {name for name in expected if f"[{name}" not in output}
            if code == 0 or missing or not expected:
                self.fail(f"{canary.name}: not reported: {', '.join(sorted(missing)) or 'by exit code'}", output)

    def cppcheck(self, files):
        filters = [f"--file-filter={name}" for name in files]
        return [*CPPCHECK, f"-j{os.cpu_count() or 1}", f"--project={self.database / 'compile_commands.json'}", *filters]

    def tidy(self, files):
        tool = shutil.which("run-clang-tidy") or shutil.which("run-clang-tidy-14") or "run-clang-tidy"
        return [tool, "-quiet", f"-j{os.cpu_count() or 1}", f"-p={self.database}",
                *(f"^{re.escape(name)}$" for name in self.bundled(files))]

    def check_cppcheck(self):
        units = self.units_in(ANALYZED)
        say(f"cppcheck: {len(units)} units")
        code, output = run(self.cppcheck(units))
        if code != 0 or not units:
            self.fail("cppcheck", output)

    def check_tidy(self):
        units = self.units_in(ANALYZED)
        say(f"clang-tidy: {len(units)} units")
        code, output = run(self.tidy(units))
        findings = sorted(set(re.findall(r"^/\S+:\d+:\d+: (?:error|warning): .*$", output, re.M)))
        if code != 0 or not units:
            self.fail("clang-tidy", "\n".join(findings) or output)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--only", choices=["format", "database", "canaries", "cppcheck", "tidy"])
    options = parser.parse_args()
    for tool in ("clang-format", "cppcheck", "clang-tidy"):
        if shutil.which(tool) is None:
            print(f"analyze: {tool} is missing: run toolchains/setup.sh host", file=sys.stderr)
            return 2

    analysis = Analysis(options.source.resolve(), options.build.resolve())
    for step in ("format", "database", "canaries", "cppcheck", "tidy"):
        if options.only in (None, step):
            getattr(analysis, f"check_{step}")()
    say(f"analyze: failed: {', '.join(analysis.failed)}" if analysis.failed else "analyze: no findings")
    return 1 if analysis.failed else 0


if __name__ == "__main__":
    sys.exit(main())
