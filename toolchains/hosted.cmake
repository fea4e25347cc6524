# SPDX-License-Identifier: MIT
# batuta_target_is_hosted(<variable>): ON where the compiler says that there is an operating system below its programs. Toolchains
# for boards have names of all kinds (Generic, PICO, Zephyr, ...); what the compiler defines follows from the target.
include(CheckCXXSourceCompiles)

function(batuta_target_is_hosted variable)
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # a board's program may need more than a compiler to link
  set(CMAKE_REQUIRED_QUIET ON)
  check_cxx_source_compiles("
    #if !defined(__linux__) && !defined(__unix__) && !defined(__APPLE__) && !defined(_WIN32) && !defined(__EMSCRIPTEN__)
    #error bare metal
    #endif
    int hosted;" BATUTA_TARGET_IS_HOSTED)
  set(${variable} OFF PARENT_SCOPE)
  if(BATUTA_TARGET_IS_HOSTED)
    set(${variable} ON PARENT_SCOPE)
  endif()
endfunction()
