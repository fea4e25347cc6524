# SPDX-License-Identifier: MIT
# Fails unless PROGRAM runs, holds the search SEARCH, and none of the others.
execute_process(COMMAND ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NM} --demangle ${PROGRAM} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
foreach(search Stepping Advancement Translation)
  string(TOLOWER "search_${search}" function)
  string(FIND "${symbols}" "batuta::${function}<" place)
  if(search STREQUAL SEARCH AND place EQUAL -1)
    message(FATAL_ERROR "the scene names ${search}, but there is no ${function}")
  elseif(NOT search STREQUAL SEARCH AND NOT place EQUAL -1)
    message(FATAL_ERROR "the scene names ${SEARCH}, but ${function} is linked")
  endif()
endforeach()
