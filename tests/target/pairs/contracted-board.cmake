# SPDX-License-Identifier: MIT
# The same planted fault on a board.
include(${CMAKE_CURRENT_LIST_DIR}/../../../toolchains/arm-none-eabi.cmake)
set(CMAKE_CXX_COMPILE_OBJECT
    "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -ffp-contract=fast -o <OBJECT> -c <SOURCE>")
