# SPDX-License-Identifier: MIT
"""A tree of its own in which a mutated file is compiled and linked with the objects of a finished build, so that one
mutation costs the compilation of what reads its file, one link, and the tests up to the first that fails."""
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess

LEAST_PATIENCE = 15
TIME_IS_UP = (-signal.SIGXCPU, -signal.SIGKILL)
SOURCES = ("include", "src", "tests", "port")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)
# Few seconds to compile, and the same bits as any other: contraction is off everywhere. What only warns is no finding.
FLAGS = ["-Og", "-w"]
# What every file of a folder begins with costs half its compilation: compiled once, unless it is mutated itself.
EIGEN = "include/batuta/core/types.hpp"
HEADS = {"src/": '#include "batuta/core/types.hpp"\n',
         "tests/unit/": '#include "batuta/core/types.hpp"\n#include <gmock/gmock.h>\n#include <rapidcheck/gtest.h>\n'}
SEED = "20061107"  # of the property tests, as in tests/CMakeLists.txt
PREPARED = "cmake_pch.hxx"  # what the build reads before all tests


class NotReady(Exception):
    pass


def without_prepared(command):
    """Without the headers that the build prepares: they name the files of the source, beside which a mutated one would
    not compile."""
    at = [i for i, part in enumerate(command[:-1]) if part == "-include" and command[i + 1].endswith(PREPARED)]
    return [part for i, part in enumerate(command) if i not in at and i - 1 not in at]


class Run:
    """How a test program ended."""

    def __init__(self, passed, text=""):
        self.passed = passed
        self.text = text

    def killer(self):
        """The first test that failed, or how the program ended without one."""
        failed = re.search(r"^\[  FAILED  \] (\S+?),?(?: |$)", self.text, re.M)
        return failed.group(1) if failed else self.text.strip().splitlines()[-1][:80] if self.text.strip() else "trap"


class Bench:
    def __init__(self, source, build, folder):
        self.source = source
        self.build = build
        self.tree = folder / "tree"
        self.objects = folder / "objects"
        self.commands = {}  # file, relative to the source: how it is compiled
        self.readers = {}   # header, relative to the source: files that include it, directly

    def set_up(self, programs, keep):
        """Builds, and copies the sources and the objects of `programs`; keep: uses the copies of last time."""
        if not keep:
            self.bring_up_to_date(programs)
            self.copy_sources()
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            path = pathlib.Path(entry["file"])
            if self.source in path.parents:
                self.commands[str(path.relative_to(self.source))] = shlex.split(entry["command"])
        if not self.commands:  # then no mutation would be compiled, and each of them would live
            raise NotReady(f"{self.build} is not a build of {self.source}")
        for program in programs:
            if not keep:
                self.copy_objects(program)
        self.find_readers()
        if not keep:
            self.precompile()

    def bring_up_to_date(self, programs):
        done = subprocess.run(["ninja", "-C", self.build, *programs], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        if done.returncode != 0:
            raise NotReady(f"does not build: {done.stdout[-2000:]}")

    def copy_sources(self):
        shutil.rmtree(self.tree, ignore_errors=True)
        shutil.rmtree(self.objects, ignore_errors=True)
        for folder in SOURCES:
            shutil.copytree(self.source / folder, self.tree / folder, ignore=shutil.ignore_patterns("__pycache__"))

    def link_command(self, program):
        """[compiler, ...], with paths relative to the build."""
        ask = ["ninja", "-C", self.build, "-t", "commands", "-s", f"tests/{program}"]
        lines = subprocess.run(ask, capture_output=True, text=True, check=True).stdout.splitlines()
        steps = [step.strip() for step in lines[-1].split("&&")]
        return shlex.split(next(step for step in steps if " -o " in step))

    def copy_objects(self, program):
        for part in self.link_command(program):
            if part.endswith((".o", ".a")) and not part.startswith("/"):
                target = self.objects / part
                if not target.exists():
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy2(self.build / part, target)
        (self.objects / f"{program}.json").write_text(json.dumps(self.link_command(program)))

    def find_readers(self):
        for folder in SOURCES:
            for path in (self.tree / folder).rglob("*.?pp"):
                for name in INCLUDE.findall(path.read_text(errors="replace")):
                    self.note_reader(path, name)

    def note_reader(self, path, name):
        for base in (path.parent, self.tree / "include", self.tree / "port", self.tree / "tests" / "support"):
            target = pathlib.Path(os.path.normpath(base / name))
            if target.is_file():
                header = str(target.relative_to(self.tree))
                self.readers.setdefault(header, set()).add(str(path.relative_to(self.tree)))
                return

    def files_reading(self, file):
        """The files that include `file`, directly or not, and itself."""
        seen, waiting = {file}, [file]
        while waiting:  # Bound: every file once
            for reader in self.readers.get(waiting.pop(), set()) - seen:
                seen.add(reader)
                waiting.append(reader)
        return seen

    def units_reading(self, file):
        return sorted(name for name in self.files_reading(file) if name in self.commands)

    def head(self, prefix):
        return self.tree / f"{prefix.strip('/').replace('/', '_')}.hpp"

    def precompile(self):
        """Where it cannot be done, the compiler reads the text."""
        for prefix, text in HEADS.items():
            unit = next((unit for unit in self.units_reading(EIGEN) if unit.startswith(prefix)), None)
            if unit:
                self.head(prefix).write_text(text)
                command = self.compiler(unit)
                command[command.index("-o") + 1] = f"{self.head(prefix)}.gch"
                command[command.index("-c"):] = ["-x", "c++-header", str(self.head(prefix))]
                subprocess.run(command, cwd=self.objects, capture_output=True, check=False)

    def compiler(self, unit):
        """The command that compiles a file of the tree, fast."""
        given = without_prepared(self.commands[unit])
        command = [part.replace(f"{self.source}/", f"{self.tree}/")
                   if re.search(rf"{re.escape(str(self.source))}/(?:{'|'.join(SOURCES)})\b", part) else part
                   for part in given if not re.fullmatch(r"-O.|-g.?|-Werror|-W(?!l,).*", part)]
        command[1:1] = FLAGS
        return command

    def compile(self, unit, mutated):
        """The object of a file of the tree, or None where it does not compile."""
        command = self.compiler(unit)
        target = self.objects / "mutated" / (unit.replace("/", "_") + ".o")
        target.parent.mkdir(parents=True, exist_ok=True)
        command[command.index("-o") + 1] = str(target)
        for prefix in HEADS:
            if unit.startswith(prefix) and self.head(prefix).is_file() and EIGEN not in self.files_reading(mutated):
                command[1:1] = ["-include", str(self.head(prefix))]
        done = subprocess.run(command, cwd=self.objects, capture_output=True, check=False)
        return target if done.returncode == 0 else None

    def link(self, program, mutated, only_test=None):
        """The program with the mutated objects before all others, whose names they win; only_test: without the
        other files of tests, which have seen the file as it was. None where it does not link."""
        command = json.loads((self.objects / f"{program}.json").read_text())
        if only_test:
            command = [part for part in command if not part.endswith("_test.cpp.o")]
        own = {pathlib.Path(self.object_of(unit)).as_posix() for unit in mutated if not unit.startswith("src/")}
        command = [part for part in command if part not in own]
        command[command.index("-o") + 1] = str(self.objects / "program")
        command[1:1] = [str(target) for target in mutated.values()]
        # With fewer objects the order in which the libraries stand need not do.
        command.insert(command.index("-o") + 2, "-Wl,--start-group")
        command.append("-Wl,--end-group")
        done = subprocess.run(command, cwd=self.objects, capture_output=True, check=False)
        return self.objects / "program" if done.returncode == 0 else None

    def object_of(self, unit):
        command = self.commands[unit]
        return command[command.index("-o") + 1]

    def run(self, executable, seconds):
        """`seconds` are those of the processor: a machine that does something else as well kills no mutation."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 1))

        done = subprocess.run([executable, "--gtest_fail_fast", "--gtest_brief=1"], cwd=self.objects, preexec_fn=limit,
                              env=dict(os.environ, RC_PARAMS=f"seed={SEED}"), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, errors="replace", text=True, check=False)
        return Run(done.returncode == 0, "hangs" if done.returncode in TIME_IS_UP else done.stdout)

    def patience_with(self, program):
        """After how many seconds of the processor's time a program with a mutation hangs."""
        return LEAST_PATIENCE + 6 * self.time_of(program)

    def time_of(self, program):
        """How many of these seconds it takes as it is; it must pass."""
        note = self.objects / f"{program}.seconds"
        if not note.is_file():
            begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            result = self.run(self.link(program, {}), 600)
            if not result.passed:
                raise NotReady(f"{program} fails without a mutation: {result.killer()}")
            note.write_text(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin))
        return float(note.read_text())
