# SPDX-License-Identifier: MIT
# The machine that builds, treated as one target among others: programs of tests/target, no GoogleTest.
set(CMAKE_SYSTEM_NAME ${CMAKE_HOST_SYSTEM_NAME})
set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_HOST_SYSTEM_PROCESSOR})
