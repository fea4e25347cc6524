# SPDX-License-Identifier: MIT
"""PlatformIO runs this when it builds the library (library.json, extraScript): what every file of the project is compiled with as
well, and where Eigen is, whose library for Arduino keeps it in a folder of its own. The project's own files have an environment of
theirs, made before this is run."""

import glob
import os

Import("env")  # noqa: F821, of PlatformIO
from SCons.Errors import UserError  # noqa: E402
from SCons.Script import DefaultEnvironment  # noqa: E402

EVERYWHERE = {"CCFLAGS": ["-ffp-contract=off"], "CPPDEFINES": [("BATUTA_WITH_DOUBLE", 0), "BATUTA_CONTRACTION_IS_OFF"]}
STANDARD = "-std=gnu++17"  # or a newer one, where the project has that
TOO_OLD = ("98", "03", "0x", "11", "1y", "14")


def eigen_folders(environment):
    """Folders of the project's libraries that hold Eigen/Core."""
    libraries = environment.subst("$PROJECT_LIBDEPS_DIR/$PIOENV")
    found = glob.glob(os.path.join(libraries, "*", "ArduinoEigen", "Eigen", "Core"))
    found += glob.glob(os.path.join(libraries, "*", "Eigen", "Core"))
    return [os.path.dirname(os.path.dirname(core)) for core in sorted(found)][:1]


def standard(environment):
    """The flag for it that is missing: the last one counts."""
    told = [flag for flag in map(str, environment.get("CXXFLAGS", [])) if flag.startswith("-std=")]
    return [] if told and not told[-1].endswith(TOO_OLD) else [STANDARD]


def projects_own():
    """The environment of the project's own files, where this PlatformIO hands it to a library."""
    try:
        Import("projenv")  # noqa: F821
        return [projenv]  # noqa: F821
    except UserError:
        print("batuta: this PlatformIO keeps the flags of your own files to itself. In platformio.ini: build_unflags = -std=gnu++11, "
              "build_flags = -std=gnu++17 -ffp-contract=off -DBATUTA_WITH_DOUBLE=0 -DBATUTA_CONTRACTION_IS_OFF")
        return []


for environment in [env, DefaultEnvironment(), *projects_own()]:  # noqa: F821
    environment.Append(CPPPATH=eigen_folders(environment), CXXFLAGS=standard(environment), **EVERYWHERE)
