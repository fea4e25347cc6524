# SPDX-License-Identifier: MIT
# The contract suite for a port of your own (docs/porting.md). Include this file behind add_subdirectory(batuta).

# batuta_port_contract(<name> <file with your tests>...): a program that runs the suite by GoogleTest, and a ctest test of
# that name.
function(batuta_port_contract name)
  find_package(GTest 1.12 REQUIRED)
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH tests)
  add_executable(${name} ${ARGN} ${tests}/support/heap_trap.cpp)
  target_include_directories(${name} PRIVATE ${tests}/port ${tests}/support)
  target_link_libraries(${name} PRIVATE batuta::batuta GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
endfunction()

# batuta_port_contract_on_board(<name> <file with main()>...): the same checks without a test framework or a heap: what is
# flashed. How it is run, and where its lines are read, is the board's.
function(batuta_port_contract_on_board name)
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH tests)
  set(trap heap_trap_of_board.cpp)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(trap heap_trap.cpp)  # its console has a heap
  endif()
  add_executable(${name} ${ARGN} ${tests}/support/${trap})
  target_include_directories(${name} PRIVATE ${tests}/port ${tests}/support)
  target_link_libraries(${name} PRIVATE batuta::batuta)
endfunction()
