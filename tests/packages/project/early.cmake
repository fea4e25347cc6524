# SPDX-License-Identifier: MIT
# As ESP-IDF reads a component's CMakeLists.txt to learn what it requires: a script, in which registering ends the reading, and
# in which there are no targets.
set(CMAKE_BUILD_EARLY_EXPANSION 1)
macro(idf_component_register)
  set(registered 1)
  return()
endmacro()
macro(project)
  message(FATAL_ERROR "project() is called in a script")
endmacro()
function(target_compile_options)
  message(FATAL_ERROR "a target is asked for before there is one")
endfunction()
include(${ARCHIVE}/CMakeLists.txt)
if(NOT registered)
  message(FATAL_ERROR "the component does not register itself")
endif()
