#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each archive is made, unpacked elsewhere, and built there by what reads it.
Usage: archives_test.py SOURCE_FOLDER EIGEN WORK_FOLDER NAME. Exit code 77: skipped, for a tool is not there."""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import xml.etree.ElementTree as ElementTree
import zipfile

SOURCE, EIGEN, WORK = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
NAME = sys.argv[4]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(SOURCE / "toolchains/packages"))
import archives  # noqa: E402
import project as names  # noqa: E402

SKIPPED = 77
BEAT = "beat at 47 ms, 1.35 N s, 67 % up the first blade\n"  # (0.2 - 0.01) m at 4 m/s
PROJECT = names.read_project(SOURCE)


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def run(*words, **more):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **more)
    check(done.returncode == 0, f"{words}\n{done.stdout[-8000:]}")
    return done.stdout


def fresh(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def unpacked(ending):
    """A folder into which the archive of that ending was unpacked; the same archive has the same bytes when it is made again."""
    folder = fresh(NAME)
    made = [name for name in archives.make(PROJECT, folder / "made") if name.endswith(ending)]
    check(len(made) == 1, f"archives that end in {ending}: {made}")
    archive = folder / "made" / made[0]
    first = archive.read_bytes()
    archives.make(PROJECT, folder / "made")
    check(archive.read_bytes() == first, f"{archive.name} differs when it is made again")
    opened = tarfile.open(archive) if ending.endswith(".gz") else zipfile.ZipFile(archive)
    with opened:
        opened.extractall(folder / "unpacked")
    return folder / "unpacked"


def build(system, archive, **values):
    """Builds and runs the README's example from an unpacked archive."""
    tree = WORK / NAME / "build"
    shutil.rmtree(tree, ignore_errors=True)
    lists = [f"-D{key}={';'.join(words)}" for key, words in values.items()]
    how = [f"-DSYSTEM={system}", f"-DARCHIVE={archive}", f"-DEIGEN={EIGEN}", f"-DCONSUMER={SOURCE / 'tests/consumer/project'}"]
    run("cmake", "-S", HERE / "project", "-B", tree, "-G", "Ninja", *how, *lists)
    run("cmake", "--build", tree)
    check(run(tree / "beat") == BEAT, run(tree / "beat"))


def is_noticed(system, archive, **values):
    """The same without one of its files must not build."""
    victim = archive / PROJECT.sources()[5]
    victim.unlink()
    tree = WORK / NAME / "planted"
    lists = [f"-D{key}={';'.join(words)}" for key, words in values.items()]
    how = [f"-DSYSTEM={system}", f"-DARCHIVE={archive}", f"-DEIGEN={EIGEN}", f"-DCONSUMER={SOURCE / 'tests/consumer/project'}"]
    done = subprocess.run(["cmake", "-S", str(HERE / "project"), "-B", str(tree), "-G", "Ninja", *how, *lists], capture_output=True,
                          text=True, check=False)
    told = " ".join((done.stdout + done.stderr).split())
    check(done.returncode != 0 and victim.name in told, f"a missing {victim.name} is not noticed: {told}")


def esp_idf():
    import yaml
    folder = unpacked("-esp-idf.tar.gz")
    manifest = yaml.safe_load((folder / "idf_component.yml").read_text(encoding="utf-8"))
    check(manifest["version"] == PROJECT.version, manifest)
    check(manifest["dependencies"]["espressif/eigen"]["public"] is True, manifest)
    build("esp-idf", folder)
    is_noticed("esp-idf", folder)


def zephyr():
    import yaml
    folder = unpacked("-zephyr.tar.gz") / PROJECT.name
    module = yaml.safe_load((folder / "zephyr/module.yml").read_text(encoding="utf-8"))
    check(module["name"] == PROJECT.name, module)
    for path in (f"{module['build']['cmake']}/CMakeLists.txt", module["build"]["kconfig"]):
        check((folder / path).is_file(), f"module.yml names {path}")
    build("zephyr", folder)
    is_noticed("zephyr", folder)


def kconfig():
    """The module's choices as Kconfig reads them, below the symbols of Zephyr that it stands on."""
    if importlib.util.find_spec("kconfiglib") is None:
        print("LEFT OUT: there is no kconfiglib (toolchains/setup.sh packages)")
        return SKIPPED
    import kconfiglib
    folder = unpacked("-zephyr.tar.gz") / PROJECT.name
    frame = folder / "Kconfig"
    frame.write_text('config CPP\n\tbool "C++"\nconfig REQUIRES_FULL_LIBCPP\n\tbool\n'
                     'config INPUT\n\tbool "Input"\nconfig PWM\n\tbool "PWM"\nsource "zephyr/Kconfig"\n', encoding="utf-8")
    os.environ["srctree"] = str(folder)
    choices = kconfiglib.Kconfig("Kconfig", warn_to_stderr=False)
    check(not choices.warnings, choices.warnings)
    symbols = choices.syms
    check(symbols["BATUTA"].set_value("y") and symbols["BATUTA"].str_value == "n", "BATUTA is chosen without C++")
    symbols["CPP"].set_value("y")
    check(symbols["BATUTA"].str_value == "y" and symbols["REQUIRES_FULL_LIBCPP"].str_value == "y", "BATUTA cannot be chosen")
    check(symbols["BATUTA_ASSERT_LEVEL"].str_value == "2", symbols["BATUTA_ASSERT_LEVEL"])
    for symbol in ("INPUT", "PWM"):
        check(symbols["BATUTA_PORT"].str_value == "n", f"ports without {symbol}")
        symbols[symbol].set_value("y")
    check(symbols["BATUTA_PORT"].str_value == "y", "ports are not chosen where Zephyr has what they stand on")
    symbols["BATUTA_ASSERT_LEVEL"].set_value("4")
    check(symbols["BATUTA_ASSERT_LEVEL"].str_value != "4", "an assert level that there is not")
    asked = set((folder / "zephyr/CMakeLists.txt").read_text(encoding="utf-8").replace("}", " ").replace(")", " ").split("CONFIG_")[1:])
    unknown = {word.split()[0].split('/')[0].split('=')[0].strip('\\"') for word in asked} - set(symbols)
    check(not unknown, f"zephyr/CMakeLists.txt asks for {unknown}, which Kconfig does not have")
    return 0


class Environment(dict):
    """What the script asks of one of SCons'. @param libraries  the folder of a project's libraries"""
    def __init__(self, libraries, **start):
        super().__init__(start)
        self.libraries = libraries

    def subst(self, text):
        check(text == "$PROJECT_LIBDEPS_DIR/$PIOENV", text)
        return str(self.libraries)

    def Append(self, **more):
        for key, values in more.items():
            self.setdefault(key, []).extend(values)


def platformio_environments(script, libraries, project_flags):
    """What the script does to a build, in PlatformIO's order: the project's own files have a copy of the global environment, made
    before libraries are looked at. @param project_flags  None: this PlatformIO does not hand that copy to a library"""
    class UserError(Exception):
        pass

    everyones = Environment(libraries)
    exported = {"env": Environment(libraries)}
    if project_flags is not None:
        exported["projenv"] = Environment(libraries, CXXFLAGS=list(project_flags))
    scope = {}

    def take(name):
        if name not in exported:
            raise UserError(name)
        scope[name] = exported[name]

    modules = {name: type(sys)(name) for name in ("SCons", "SCons.Script", "SCons.Errors")}
    modules["SCons.Script"].DefaultEnvironment = lambda: everyones
    modules["SCons.Errors"].UserError = UserError
    sys.modules.update(modules)
    scope["Import"] = take
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(script.read_text(encoding="utf-8"), str(script), "exec"), scope)
    return {"everyone's": everyones, **exported}, printed.getvalue()


def platformio_flags_are_everywhere(script, libraries):
    old, new = ([], ["-std=gnu++11"], ["-std=c++17", "-std=gnu++14"]), (["-std=gnu++2b"], ["-std=c++17"])
    for flags, ours in [(flags, True) for flags in old] + [(flags, False) for flags in new]:
        environments, printed = platformio_environments(script, libraries, flags)
        check(not printed and sorted(environments) == ["env", "everyone's", "projenv"], printed)
        for name, environment in environments.items():
            check("-ffp-contract=off" in environment["CCFLAGS"], name)
            check({("BATUTA_WITH_DOUBLE", 0), "BATUTA_CONTRACTION_IS_OFF"} == set(environment["CPPDEFINES"]), name)
            check(environment["CPPPATH"] == [str(libraries / "ArduinoEigen/ArduinoEigen")], environment)
            wanted = flags + ["-std=gnu++17"] * ours if name == "projenv" else ["-std=gnu++17"]
            check(environment["CXXFLAGS"] == wanted, (name, environment["CXXFLAGS"]))
    printed = platformio_environments(script, libraries, None)[1]
    check("platformio.ini" in printed and "-ffp-contract=off" in printed, printed)


def macros_are_told(headers):
    """A file that includes Arduino.h before what the registry announces gets a sentence, and the other way round it compiles."""
    told = []
    for first, second in ("<Arduino.h>", f'"{headers}"'), (f'"{headers}"', "<Arduino.h>"):
        file = WORK / NAME / "order.cpp"
        file.write_text(f"#include {first}\n#include {second}\n", encoding="ascii")
        folders = ["-I", WORK / NAME / "unpacked/include", "-I", HERE / "arduino/core", "-isystem", EIGEN]
        done = subprocess.run(["c++", "-std=c++17", "-fsyntax-only", *folders, file], capture_output=True, text=True, check=False)
        told.append(re.findall(r" error: .*", done.stderr))
    check(len(told[0]) == 1 and "include all of batuta's headers before it" in told[0][0], told[0])
    check(not told[1], told[1])


def is_of_its_schema(manifest):
    """What PlatformIO's schema of library.json asks of the members that are there: required ones, types, lengths."""
    texts = {"$schema": 500, "name": 50, "version": 20, "description": 255, "license": 80, "headers": 255, "frameworks": 255,
             "platforms": 255}
    lists = {"keywords": str, "authors": dict, "dependencies": dict}
    check({"name", "version"} <= set(manifest) <= {*texts, *lists, "build", "export"}, sorted(manifest))
    for member, longest in texts.items():
        check(isinstance(manifest[member], str) and 0 < len(manifest[member]) <= longest, member)
    for member, kind in lists.items():
        entries = manifest[member]
        check(isinstance(entries, list) and entries and all(isinstance(entry, kind) for entry in entries), member)
    check(re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 _.-]*", manifest["name"]) and re.fullmatch(r"\d+\.\d+\.\d+", manifest["version"]), manifest)
    check(len(set(manifest["keywords"])) == len(manifest["keywords"]) and max(map(len, manifest["keywords"])) <= 50, manifest["keywords"])
    check(all("name" in entry for entry in manifest["authors"] + manifest["dependencies"]), "a name")
    check(set(manifest["export"]) <= {"include", "exclude"}, manifest["export"])
    check(set(manifest["build"]) <= {"srcDir", "includeDir", "srcFilter", "flags", "unflags", "extraScript", "libArchive", "libLDFMode",
                                     "libCompatMode"}, sorted(manifest["build"]))


def platformio():
    folder = unpacked("-platformio.tar.gz")
    manifest = json.loads((folder / "library.json").read_text(encoding="utf-8"))
    check(manifest["version"] == PROJECT.version and manifest["name"] == PROJECT.name, manifest)
    is_of_its_schema(manifest)
    building = manifest["build"]
    sources = [f"{building['srcDir']}/{word[2:-1]}" for word in building["srcFilter"] if word.startswith("+")]
    check(sorted(sources) == sorted(PROJECT.sources()), sources)
    check((folder / building["includeDir"] / manifest["headers"]).is_file(), manifest["headers"])
    macros_are_told(manifest["headers"])
    libraries = WORK / NAME / "libdeps"
    (libraries / "ArduinoEigen/ArduinoEigen").mkdir(parents=True)
    (libraries / "ArduinoEigen/ArduinoEigen/Eigen").symlink_to(EIGEN / "Eigen")
    platformio_flags_are_everywhere(folder / building["extraScript"], libraries)
    values = {"SOURCES": sources, "FLAGS": [flag for flag in building["flags"] if not flag.startswith("-D")],
              "DEFINITIONS": [flag[2:] for flag in building["flags"] if flag.startswith("-D")]}
    build("plain", folder, **values)
    is_noticed("plain", folder, **values)


def cmsis():
    folder = unpacked(".pack")
    descriptions = list(folder.glob("*.pdsc"))
    check(len(descriptions) == 1, descriptions)
    root = ElementTree.parse(descriptions[0]).getroot()
    vendor, name = root.findtext("vendor"), root.findtext("name")
    check(descriptions[0].name == f"{vendor}.{name}.pdsc", descriptions[0].name)
    check(root.find("releases/release").get("version") == PROJECT.version, "the release")
    listed = {file.get("name"): file.get("category") for file in root.iter("file")}
    missing = [file for file in listed if not (folder / file).exists()]
    check(not missing, f"listed and not in the pack: {missing}")
    there = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.suffix in (".hpp", ".h", ".cpp")}
    check(there == {file for file, kind in listed.items() if kind in ("header", "sourceCpp")}, "files of the pack are not those that it lists")
    values = {"SOURCES": [file for file, kind in listed.items() if kind == "sourceCpp"], "FLAGS": PROJECT.core_flags,
              "DEFINITIONS": PROJECT.core_definitions}
    build("plain", folder, **values)


def links_lead_somewhere(folder):
    """Pages and pictures to which the front page and the pages of docs/ lead are there."""
    for page in (folder / "README.md", *sorted((folder / "docs").glob("*.md"))):
        targets = re.findall(r"\]\(([^)#:]+[.](?:md|svg|hpp|cpp|h))(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
        lost = [target for target in targets if not (page.parent / target).resolve().exists()]
        check(not lost, f"{page.name} leads to {lost}, which the archive does not have")
        print(page.name, len(targets), "links")


def release():
    """One folder, as the README says to use it: the project that uses it is that of tests/consumer."""
    ending = f"{PROJECT.name}-{PROJECT.version}"
    folder = unpacked(f"{ending}.tar.gz") / ending
    tree = WORK / NAME / "consumer"
    run("cmake", "-S", folder / "tests/consumer/project", "-B", tree, "-G", "Ninja", f"-DBATUTA_SOURCE={folder}", f"-DEIGEN_SOURCE={EIGEN}",
        "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON", "-DBATUTA_WITH_DOUBLE=OFF", "-DBATUTA_UNITY_ROOMS=ON")
    run("cmake", "--build", tree, "--target", "consumer_beat")
    check(run(tree / "consumer_beat") == BEAT, "consumer_beat")
    links_lead_somewhere(folder)
    # It configures by itself as well, and asks for no test library.
    hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ("GTest", "rapidcheck", "benchmark", "CLI11", "PkgConfig")]
    run("cmake", "-S", folder, "-B", WORK / NAME / "alone", "-G", "Ninja", "-DBATUTA_BUILD_PROGRAMS=OFF", *hidden)
    # The contract suite of a port is whole: docs/porting.md begins with these files.
    for file in ("tests/port/template_test.cpp", "tests/port/contract_on_board.hpp", "tests/support/heap_trap.cpp",
                 "tests/support/heap_trap_of_board.cpp"):
        run("c++", "-std=c++17", "-fsyntax-only", "-ffp-contract=off", "-DBATUTA_CONTRACTION_IS_OFF", "-isystem", EIGEN,
            *(f"-I{folder / path}" for path in ("include", "port", "tests/port", "tests/support")), "-x", "c++", folder / file)


def arduino():
    missing = [tool for tool in ("arduino-builder", "arduino-ctags", "arm-none-eabi-g++") if shutil.which(tool) is None]
    if missing:
        print(f"LEFT OUT: there is no {', '.join(missing)} (toolchains/setup.sh packages, target)")
        return SKIPPED
    folder = unpacked("-arduino.zip")
    check((folder / PROJECT.name / "src/batuta.h").is_file(), "there is no src/batuta.h")
    libraries = WORK / NAME / "libraries"
    shutil.copytree(folder / PROJECT.name, libraries / PROJECT.name)
    eigen = libraries / "ArduinoEigen"
    (eigen / "ArduinoEigen").mkdir(parents=True)
    shutil.copytree(EIGEN / "Eigen", eigen / "ArduinoEigen/Eigen")
    stated = {"name": "ArduinoEigen", "version": "0.3.2", "architectures": "*", "category": "Other"}
    stated.update({key: "of the test" for key in ("author", "maintainer", "sentence", "paragraph", "url")})  # all are asked for
    (eigen / "library.properties").write_text("".join(f"{key}={value}\n" for key, value in stated.items()), encoding="ascii")
    (eigen / "ArduinoEigenDense.h").write_text('#pragma once\n#include "ArduinoEigen/Eigen/Dense"\n', encoding="ascii")
    hardware = WORK / NAME / "hardware/batuta/arm"
    shutil.copytree(HERE / "arduino", hardware)
    (hardware / "cores").mkdir()
    (hardware / "core").rename(hardware / "cores/core")
    (WORK / NAME / "tools").mkdir()
    ccache = shutil.which("ccache")
    run("sh", "-c", f"sed -i 's#@CCACHE@#{ccache or ''}#' {hardware / 'platform.txt'}")
    examples = sorted((folder / PROJECT.name / "examples").glob("*/*.ino"))
    check(len(examples) == 2, examples)
    # One after the other in the same folders: what was compiled of the library for the first serves the second.
    out, sketch = WORK / NAME / "out", WORK / NAME / "sketch/sketch.ino"
    out.mkdir()
    sketch.parent.mkdir()
    for example in examples:
        shutil.copyfile(example, sketch)
        run("arduino-builder", "-compile", "-hardware", WORK / NAME / "hardware", "-tools", WORK / NAME / "tools", "-libraries", libraries,
            "-fqbn", "batuta:arm:m4", "-build-path", out, "-warnings", "all", sketch,
            env={**os.environ, "CCACHE_BASEDIR": str(WORK), "CCACHE_NOHASHDIR": "1"})
        image = out / f"{sketch.name}.elf"
        print(example.stem, run("arm-none-eabi-size", image).splitlines()[1].split()[0], "B of code")
        listing = run("arm-none-eabi-objdump", "-d", image)
        fused = [line for line in listing.splitlines() if "\tvfma" in line or "\tvfms" in line or "\tvfnm" in line]
        check("vmul.f32" in listing and not fused, f"fused instructions: {fused[:5]}")
    return 0


CHECKS = {"esp-idf": esp_idf, "zephyr": zephyr, "kconfig": kconfig, "platformio": platformio, "cmsis": cmsis, "release": release,
          "arduino": arduino}
if __name__ == "__main__":
    sys.exit(CHECKS[NAME]() or 0)
