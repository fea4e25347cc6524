# SPDX-License-Identifier: MIT
# Builds and runs the consumer project. MODE installed: against an install tree of BUILD in a fresh prefix;
# MODE subfolder: with SOURCE by add_subdirectory().
cmake_minimum_required(VERSION 3.25)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
if(MODE STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
  set(how -DCMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  # As firmware does: float alone, each room as one source, which is quick, and an Eigen of its own.
  set(how -DBATUTA_SOURCE=${SOURCE} -DBATUTA_WITH_DOUBLE=OFF -DBATUTA_UNITY_ROOMS=ON
      -DEIGEN_SOURCE=${EIGEN} -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" ${how})
run(${CMAKE_COMMAND} --build ${WORK}/build --target consumer consumer_one_room consumer_beat consumer_link
    consumer_parts)
run(${WORK}/build/consumer_link)
run(${WORK}/build/consumer_parts)
run(${WORK}/build/consumer)
run(${WORK}/build/consumer_one_room)
execute_process(COMMAND ${WORK}/build/consumer_beat OUTPUT_VARIABLE beat COMMAND_ERROR_IS_FATAL ANY)
if(NOT beat MATCHES "^beat at 47 ms, 1.35 N s, 67 % up the first blade\n$")  # (0.2 - 0.01) m at 4 m/s
  message(FATAL_ERROR "the README's example prints: ${beat}")
endif()

# Installed, with an Eigen that is no package: a folder, or a target of the project (EIGEN_SOURCE).
if(MODE STREQUAL "installed")
  foreach(eigen BATUTA_EIGEN_PATH EIGEN_SOURCE)
    run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK}/${eigen} -G ${GENERATOR} ${how}
        -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -D${eigen}=${EIGEN} -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
    run(${CMAKE_COMMAND} --build ${WORK}/${eigen} --target consumer_one_room)
    run(${WORK}/${eigen}/consumer_one_room)
  endforeach()
  # What ports share, and the programs where they are built.
  file(GLOB found RELATIVE ${WORK}/prefix ${WORK}/prefix/bin/* ${WORK}/prefix/include/batuta-port/shared/*/*)
  string(REPLACE "," ";bin/batuta-" programs "bin/batuta-${PROGRAMS}")
  foreach(name ${programs} include/batuta-port/shared/link/frame.hpp
          include/batuta-port/shared/usb_stick/tusb_config.h include/batuta-port/shared/usb_stick/tinyusb_device.cpp)
    if(NOT name IN_LIST found)
      message(FATAL_ERROR "${name} is not installed, but ${found}")
    endif()
  endforeach()
endif()

# The arithmetic of the library's headers is that of its object code.
file(READ ${WORK}/build/compile_commands.json commands)
set(flag -ffp-contract=off)
string(JSON count LENGTH ${commands})
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON command GET ${commands} ${i} command)
  if(command MATCHES "main.cpp" AND NOT command MATCHES "${flag}")
    message(FATAL_ERROR "the consumer is compiled without ${flag}: ${command}")
  endif()
endforeach()
