# SPDX-License-Identifier: MIT
# 64-bit RISC-V under Linux, by Debian's cross compiler; runs in QEMU's user mode.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR riscv64)
set(CMAKE_CXX_COMPILER riscv64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static") # so that the emulator needs no libraries of the target
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-riscv64)

# Libraries are the target's; programs, and packages of headers (Eigen), are found on the host.
set(CMAKE_FIND_ROOT_PATH /usr/riscv64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
