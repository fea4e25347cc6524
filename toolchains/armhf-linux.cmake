# SPDX-License-Identifier: MIT
# Armv7-A with hardware floating point (VFPv3) under Linux, by Debian's cross compiler; runs in QEMU's user mode.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_CXX_FLAGS_INIT "-march=armv7-a+fp -mfloat-abi=hard")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static") # so that the emulator needs no libraries of the target
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm)

# Libraries are the target's; programs, and packages of headers (Eigen), are found on the host.
set(CMAKE_FIND_ROOT_PATH /usr/arm-linux-gnueabihf)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
