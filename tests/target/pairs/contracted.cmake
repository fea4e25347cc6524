# SPDX-License-Identifier: MIT
# A planted fault: every file is compiled with -ffp-contract=fast after all other flags, on a cpu that fuses.
include(${CMAKE_CURRENT_LIST_DIR}/../../../toolchains/aarch64-linux.cmake)
set(CMAKE_CXX_COMPILE_OBJECT
    "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -ffp-contract=fast -o <OBJECT> -c <SOURCE>")
