#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What users of the library run needs no CMake newer than 3.16: every command in the files that their CMake reads is on a list with the
version that brought it, and none has a word that came later. Usage: check_cmake.py FOLDER; prints one line a finding."""

import pathlib
import re
import sys

OLDEST = (3, 16)
# Files that a project reads which adds the library, finds it installed, or takes it by another build system; what only the project's own
# tests, programs, boards and presets read may want more.
READ = ["CMakeLists.txt", "src/**/CMakeLists.txt", "port/CMakeLists.txt", "port/template/CMakeLists.txt",
        "port/platforms/host/CMakeLists.txt", "port/platforms/cortex_m/CMakeLists.txt", "port/shared/*/CMakeLists.txt", "port/python/CMakeLists.txt",
        "toolchains/install.cmake", "toolchains/hosted.cmake", "toolchains/checks.cmake", "toolchains/batutaConfig.cmake.in",
        "toolchains/packages/*.cmake", "zephyr/CMakeLists.txt", "tests/consumer/project/CMakeLists.txt"]
OWN = {"batuta_room", "batuta_target_is_hosted"}
OTHERS = {"idf_component_register"}  # of ESP-IDF; Zephyr's begin with its name
# Since which version; where nothing is said, since before 3.0.
SINCE = {
    "add_custom_target": 0, "add_executable": 0, "add_library": 0, "add_subdirectory": 0, "check_cxx_source_compiles": 0,
    "check_required_components": 0, "cmake_minimum_required": 0, "cmake_parse_arguments": 0, "configure_package_config_file": 0,
    "else": 0, "elseif": 0, "enable_testing": 0, "endforeach": 0, "endfunction": 0, "endif": 0, "execute_process": 0, "file": 0,
    "find_dependency": 0, "find_package": 0, "find_program": 0, "foreach": 0, "function": 0, "get_filename_component": 0,
    "get_property": 0, "if": 0, "include": 0, "install": 0, "list": 0, "mark_as_advanced": 0, "math": 0, "message": 0, "option": 0,
    "project": 0, "return": 0, "set": 0, "set_property": 0, "set_source_files_properties": 0, "set_target_properties": 0, "string": 0,
    "target_compile_definitions": 0, "target_compile_features": (3, 1), "target_compile_options": 0, "target_include_directories": 0,
    "target_link_libraries": 0, "target_link_options": (3, 13), "target_sources": (3, 1), "write_basic_package_version_file": 0,
    "cmake_path": (3, 20), "cmake_language": (3, 18), "block": (3, 25), "endblock": (3, 25), "target_precompile_headers": (3, 16),
    "include_guard": (3, 10), "FetchContent_MakeAvailable": (3, 14), "add_compile_definitions": (3, 12),
}
# Words of commands, variables and generator expressions that came later.
WORDS = [
    (r"PROJECT_IS_TOP_LEVEL|\w+_IS_TOP_LEVEL", (3, 21)), (r"COMMAND_ERROR_IS_FATAL", (3, 19)), (r"COMMAND_ECHO", (3, 15)),
    (r"ZIP_LISTS", (3, 17)), (r"CMAKE_CURRENT_FUNCTION_LIST_\w+", (3, 17)), (r"CMAKE_MESSAGE_CONTEXT", (3, 17)),
    (r"file\(\s*(?:CONFIGURE|ARCHIVE_\w+|CHMOD|REAL_PATH|COPY_FILE)", (3, 18)), (r"string\(\s*JSON", (3, 19)), (r"string\(\s*HEX", (3, 18)),
    (r"FILE_SET", (3, 23)), (r"cxx_std_23", (3, 20)), (r"cxx_std_26", (3, 25)), (r"PATH_EQUAL", (3, 24)),
    (r"\$<(?:LINK_LANGUAGE|DEVICE_LINK|LINK_LIBRARY|LINK_GROUP|PATH|LIST|COMPILE_ONLY|TARGET_RUNTIME_DLLS)\b", (3, 18)),
    (r"find_(?:program|library|path|file)\([^)]*\bREQUIRED\b", (3, 18)), (r"TARGET_DIRECTORY", (3, 18)), (r"UNITY_BUILD_MODE", (3, 18)),
    (r"IMPORTED_RUNTIME_ARTIFACTS|RUNTIME_DEPENDENC\w+", (3, 21)), (r"DEPFILE", (3, 20)), (r"if\([^)]*\bDEFERRED?\b", (3, 19)),
    (r"\bPROPAGATE\b", (3, 25)), (r"DOWNLOAD_EXTRACT_TIMESTAMP|OVERRIDE_FIND_PACKAGE", (3, 24)),
]


def plain(text):
    """Without comments; strings stay, for they hold names of variables."""
    return re.sub(r"(?m)#[^\n]*$", "", text)


def findings_in(name, text):
    code = plain(text)
    for match in re.finditer(r"(?m)^\s*(\w+)\s*\(", code):
        command, line = match.group(1), code.count("\n", 0, match.start(1)) + 1
        if command in OWN | OTHERS or command.startswith("zephyr_"):
            continue
        if command not in SINCE:
            yield f"{name}:{line}: {command}() is not on the list of commands"
        elif SINCE[command] and SINCE[command] > OLDEST:
            yield f"{name}:{line}: {command}() came with CMake {SINCE[command][0]}.{SINCE[command][1]}"
    for words, since in WORDS:
        for match in re.finditer(words, code) if since > OLDEST else ():
            line = code.count("\n", 0, match.start()) + 1
            yield f"{name}:{line}: {' '.join(match.group(0).split())} came with CMake {since[0]}.{since[1]}"
    for match in re.finditer(r"cmake_minimum_required\(\s*VERSION (\d+)\.(\d+)", code):
        if tuple(map(int, match.groups())) > OLDEST:
            yield f"{name}: asks for CMake {match.group(1)}.{match.group(2)}"


def read_by_users(root):
    return sorted({path for pattern in READ for path in root.glob(pattern)})


def check(root):
    files = read_by_users(root)
    findings = [] if len(files) > 20 else [f"only {len(files)} files are looked at"]
    for path in files:
        findings += findings_in(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
    return findings


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1]))
    print("\n".join(found))
    sys.exit(1 if found else 0)
