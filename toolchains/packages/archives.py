# SPDX-License-Identifier: MIT
"""Archives for the registries, made from the project's files. The same files give the same bytes: names in order, one time for
all, which is that of the newest heading of CHANGELOG.md with a date, or the first day of 2026."""

import datetime
import gzip
import io
import os
import re
import tarfile
import zipfile

import manifests

LICENCE = ["LICENSE", "README.md"]


def day_of(project):
    found = re.search(r"^## \[[\d.]+\] - (\d{4})-(\d\d)-(\d\d)", (project.root / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)
    return datetime.date(*map(int, found.groups())) if found else datetime.date(2026, 1, 1)


def read(project, names):
    return {name: (project.root / name).read_bytes() for name in names}


def below(project, folder, kept=lambda name: True):
    found = (path for path in (project.root / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    names = (path.relative_to(project.root).as_posix() for path in found)
    return [name for name in sorted(names) if kept(name)]


def macros_of_arduino(project):
    """Macros of Arduino's cores that are names in Eigen, in the standard library or here: those that core/config.hpp refuses."""
    return re.findall(r"^#undef (\w+)$", (project.root / "include/batuta/core/config.hpp").read_text(encoding="utf-8"), re.M)


def umbrella(project):
    """batuta.h: Arduino's macros are put aside while the headers are read."""
    macros = macros_of_arduino(project)
    kept = [name for name in project.headers()
            if "/detail/" not in name and not name.endswith(("_definitions.hpp", ".h"))]
    lines = ["// SPDX-License-Identifier: MIT", "#pragma once",
             f"// batuta {project.version} for Arduino: all of it. Include it, and no header below batuta/, before anything of Eigen.",
             "#include <Arduino.h>", ""]
    for macro in macros:
        lines += [f'#pragma push_macro("{macro}")', f"#undef {macro}"]
    lines += ["", *(f'#include "{name}"' for name in kept), ""]
    lines += [f'#pragma pop_macro("{macro}")' for macro in reversed(macros)]
    return "\n".join(lines) + "\n"


def for_arduino(name, text):
    """A file of the library as Arduino builds it: without flags, without BATUTA_WITH_DOUBLE, with Eigen from ArduinoEigen."""
    if name.endswith("core/config.hpp"):
        text = text.replace("#define BATUTA_WITH_DOUBLE 1", "#define BATUTA_WITH_DOUBLE 0")
    if name.endswith("core/detail/eigen.hpp"):
        # A library is found by a header in its folder: once it is, its own folder is on the path.
        find = ("#if !__has_include(<ArduinoEigen/Eigen/Core>)\n#include <ArduinoEigenDense.h>\n#endif\n\n")
        text = text.replace("#include <new>\n", find + "#include <new>\n").replace("#include <Eigen/", "#include <ArduinoEigen/Eigen/")
    return text


def arduino_tree(project):
    files = read(project, LICENCE)
    files["library.properties"] = manifests.arduino(project).encode()
    files["src/batuta.h"] = umbrella(project).encode()
    for name in project.files():
        text = for_arduino(name, (project.root / name).read_text(encoding="utf-8"))
        files[f"src/{name.split('/', 1)[1]}"] = text.encode()
    for example in below(project, "toolchains/packages/arduino"):
        noun = example.rsplit("/", 1)[1][:-len(".ino")]
        files[f"examples/{noun}/{noun}.ino"] = (project.root / example).read_bytes()
    return files


def compiled(project):
    return read(project, LICENCE + project.files())


def platformio_tree(project):
    examples = below(project, "examples", lambda name: name.endswith(".cpp"))
    return {**compiled(project), **read(project, ["library.json", "toolchains/packages/platformio_flags.py", *examples])}


def esp_idf_tree(project):
    names = ["idf_component.yml", "CMakeLists.txt", "toolchains/packages/esp_idf.cmake", "toolchains/packages/files.cmake"]
    return {**compiled(project), **read(project, names)}


def zephyr_tree(project):
    port = [*below(project, "port/platforms/zephyr"), "port/shared/drivers/bridge_duty.hpp"]
    return {**compiled(project), **read(project, [*below(project, "zephyr"), *port, "toolchains/packages/files.cmake"])}


def cmsis_tree(project):
    name = f"{project.name}.{project.name}.pdsc"
    text = manifests.cmsis_pack(project, project.files(), day_of(project).isoformat())
    return {name: text.encode(), **read(project, ["CHANGELOG.md"]), **compiled(project)}


def release_tree(project):
    """What a user of the sources may want, in one folder: all but the project's own tests."""
    suite = ["contract.cmake", "contract_checks.hpp", "contract_on_board.hpp", "contract_suite.hpp", "template_rigs.hpp", "template_test.cpp"]
    support = ["heap_trap.cpp", "heap_trap.hpp", "heap_trap_of_board.cpp", "plain_force.hpp"]
    tests = [f"tests/port/{name}" for name in suite] + [f"tests/support/{name}" for name in support]
    tests += below(project, "tests/consumer/project")  # README.md, "Install it"
    top = ["CMakeLists.txt", "CMakePresets.json", "CHANGELOG.md", *manifests.committed(project)]
    folders = [name for folder in ("include", "src", "port", "toolchains", "zephyr", "docs", "examples") for name in below(project, folder)]
    files = read(project, dict.fromkeys(LICENCE + top + tests + folders))
    return files | read(project, dict.fromkeys(pictures(project, files)))


def pictures(project, files):
    """What the pages among some files show, wherever it lies."""
    for page in filter(lambda name: name.endswith(".md"), files):
        for target in re.findall(r"\]\(([^)#]+[.]svg)\)", files[page].decode("utf-8")):
            path = os.path.normpath(os.path.join(os.path.dirname(page), target))
            if (project.root / path).is_file():
                yield path


def write_zip(path, folder, files, day):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(folder + name, (day.year, day.month, day.day, 0, 0, 0))
            entry.external_attr, entry.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])


def write_tar(path, folder, files, day):
    time = int(datetime.datetime(day.year, day.month, day.day, tzinfo=datetime.timezone.utc).timestamp())
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(files):
            entry = tarfile.TarInfo(folder + name)
            entry.size, entry.mtime, entry.mode = len(files[name]), time, 0o644
            archive.addfile(entry, io.BytesIO(files[name]))
    path.write_bytes(gzip.compress(plain.getvalue(), mtime=time))


def make(project, out):
    """Writes all archives into a folder; returns their names."""
    stem, day = f"{project.name}-{project.version}", day_of(project)
    plan = [
        (f"{stem}.tar.gz", write_tar, f"{stem}/", release_tree),
        (f"{stem}-arduino.zip", write_zip, f"{project.name}/", arduino_tree),
        (f"{stem}-platformio.tar.gz", write_tar, "", platformio_tree),
        (f"{stem}-esp-idf.tar.gz", write_tar, "", esp_idf_tree),
        (f"{stem}-zephyr.tar.gz", write_tar, f"{project.name}/", zephyr_tree),
        (f"{project.name}.{project.name}.{project.version}.pack", write_zip, "", cmsis_tree),
    ]
    out.mkdir(parents=True, exist_ok=True)
    for name, write, folder, tree in plan:
        write(out / name, folder, tree(project), day)
    return [name for name, *_ in plan]
