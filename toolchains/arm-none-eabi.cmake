# SPDX-License-Identifier: MIT
# Bare-metal Arm with newlib-nano. Three small files make a target: this one (how to compile), cpu/<cpu>.cmake
# (flags of the core only) and port/<port>/board/<board>.cmake (memory map, emulator).
#   -DBATUTA_CPU=cortex-m4f -DBATUTA_BOARD=mps2/an386
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)  # only for a USB stack that somebody brings: the library has no C
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # nothing links without a board's start-up
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES BATUTA_CPU BATUTA_BOARD)

set(BATUTA_CPU "cortex-m4f" CACHE STRING "Core: a file of toolchains/cpu")
set(BATUTA_BOARD "mps2/an386" CACHE STRING "Board: <port>/<file of port/<port>/board>")

# Sets BATUTA_CPU_FLAGS.
include(${CMAKE_CURRENT_LIST_DIR}/cpu/${BATUTA_CPU}.cmake)
# Sets BATUTA_BOARD_MACHINE (of QEMU) and BATUTA_BOARD_LINKER_SCRIPT.
string(REPLACE "/" "/board/" board_file ${BATUTA_BOARD})
include(${CMAKE_CURRENT_LIST_DIR}/../port/platforms/${board_file}.cmake)

set(CMAKE_CXX_FLAGS_INIT "${BATUTA_CPU_FLAGS} -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections")
set(CMAKE_C_FLAGS_INIT "${BATUTA_CPU_FLAGS} -ffunction-sections -fdata-sections")
set(CMAKE_C_FLAGS_RELEASE "-Os -DNDEBUG" CACHE STRING "C compiler flags of a Release build")
# -Os: with Eigen told to inline (core/detail/eigen.hpp) it takes less flash and less time than -O2 (docs/cost.md). The
# parameter: a call is inlined where that adds 10 instructions, not 0.
# Not ..._INIT: CMake would append its own -O3 to that.
set(CMAKE_CXX_FLAGS_RELEASE "-Os --param max-inline-insns-size=10 -DNDEBUG" CACHE STRING "Compiler flags of a Release build")
set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=nano.specs -nostartfiles -Wl,--gc-sections -Wl,--fatal-warnings")
set(CMAKE_EXECUTABLE_SUFFIX .elf)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)

# Plain add_test(NAME x COMMAND x ARGUMENT...) runs in the emulator.
set(CMAKE_CROSSCOMPILING_EMULATOR sh ${CMAKE_CURRENT_LIST_DIR}/emulate.sh ${BATUTA_BOARD_MACHINE})

# Programs come from the host; Eigen is header-only and is found there, too.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
