# SPDX-License-Identifier: MIT
# 64-bit Arm under Linux, by Debian's cross compiler; runs in QEMU's user mode.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static") # so that the emulator needs no libraries of the target
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)

# Libraries are the target's; programs, and packages of headers (Eigen), are found on the host.
set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
