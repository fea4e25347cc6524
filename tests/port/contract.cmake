# SPDX-License-Identifier: MIT
# The contract suite for a port of your own (docs/porting.md). Include this file behind add_subdirectory(batuta).
find_package(GTest 1.12 REQUIRED)

# batuta_port_contract(<name> <file with your rigs>...): a program that runs the suite, and a ctest test of that name.
function(batuta_port_contract name)
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH tests)
  add_executable(${name} ${ARGN} ${tests}/support/heap_trap.cpp)
  target_include_directories(${name} PRIVATE ${tests}/port ${tests}/support)
  target_link_libraries(${name} PRIVATE batuta::batuta GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
endfunction()
