# SPDX-License-Identifier: MIT
"""PlatformIO runs this when it builds the library (library.json, extraScript): what every file of the project is compiled with as
well, and where Eigen is, whose library for Arduino keeps it in a folder of its own."""

import glob
import os

Import("env")  # noqa: F821, of PlatformIO
from SCons.Script import DefaultEnvironment  # noqa: E402

EVERYWHERE = {"CCFLAGS": ["-ffp-contract=off"], "CXXFLAGS": ["-std=gnu++17"], "CPPDEFINES": [("BATUTA_WITH_DOUBLE", 0), "BATUTA_CONTRACTION_IS_OFF"]}


def eigen_folders(environment):
    """Folders of the project's libraries that hold Eigen/Core."""
    libraries = environment.subst("$PROJECT_LIBDEPS_DIR/$PIOENV")
    found = glob.glob(os.path.join(libraries, "*", "ArduinoEigen", "Eigen", "Core"))
    found += glob.glob(os.path.join(libraries, "*", "Eigen", "Core"))
    return [os.path.dirname(os.path.dirname(core)) for core in sorted(found)][:1]


for environment in (env, DefaultEnvironment()):  # noqa: F821
    environment.Append(CPPPATH=eigen_folders(environment), **EVERYWHERE)
