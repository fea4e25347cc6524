# SPDX-License-Identifier: MIT
"""What a Makefile needs to know of the library: docs/porting.md has it between two marks, as a file to be included."""

import re
import textwrap

PAGE = "docs/porting.md"
BEGIN, END = "<!-- begin batuta.mk, by toolchains/packages -->\n", "<!-- end -->\n"
WIDTH = 110


def variable(name, words):
    lines = textwrap.wrap(" ".join([name, "=", *words]), WIDTH, break_long_words=False, break_on_hyphens=False,
                          subsequent_indent="  ")
    return " \\\n".join(lines) + "\n"


def makefile(project):
    rooms = "".join(variable(f"BATUTA_{room.name}", room.sources) for room in project.rooms)
    return "\n".join([
        f"# my_firmware/batuta.mk\n# {project.name} {project.version}: files, include folder and flags, as its own build has them.\n",
        variable("BATUTA_INCLUDE", ["include"]) +
        variable("BATUTA_FLAGS", project.flags) +
        variable("BATUTA_CORE_FLAGS", [f"-D{word}" for word in project.core_definitions] + project.core_flags) +
        variable("BATUTA_ROOMS", [room.name for room in project.rooms]),
        rooms])


def page_with(text, project):
    """The page with its block as it has to be."""
    block = f"{BEGIN}```make\n{makefile(project)}```\n{END}"
    filled, count = re.subn(re.escape(BEGIN) + r".*?" + re.escape(END), lambda _: block, text, flags=re.S)
    if count != 1:
        raise SystemExit(f"{PAGE}: '{BEGIN.strip()}' ... '{END.strip()}' occurs {count} times, not once")
    return filled
