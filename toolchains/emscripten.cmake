# SPDX-License-Identifier: MIT
# WebAssembly, by Debian's emscripten; programs run in node. Its prebuilt libraries are used as they are: EM_CACHE stays
# unset.
find_program(BATUTA_EMSCRIPTEN em++ REQUIRED)
file(REAL_PATH ${BATUTA_EMSCRIPTEN} emscripten)
get_filename_component(emscripten ${emscripten} DIRECTORY)
if(NOT EXISTS ${emscripten}/cmake)
  set(emscripten /usr/share/emscripten)  # Debian's em++ is a script that starts what is there
endif()
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_CXX_COMPILER em++)
# This emscripten takes a fetch() for a browser's, which reads no files.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)

# Its linker starts scripts of node, whose modules Debian keeps here.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
# A package of headers (Eigen) is the machine's own.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
# A program of the tests reads and writes files of the machine.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1 -sEXIT_RUNTIME=1")
