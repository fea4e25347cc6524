# SPDX-License-Identifier: MIT
# Compiles FILE with COMPILER and fails unless that gives exactly one line with `error:`, EXPECTED is in it, and there are at most 15
# lines in all.
execute_process(COMMAND ${COMPILER} @${FLAG_FILE} ${FLAGS} -fsyntax-only ${FILE}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "must not compile, but does")
endif()
string(REPLACE ";" "," output "${output}")  # a list has no semicolons in its items
string(STRIP "${output}" output)
string(REPLACE "\n" ";" lines "${output}")
list(LENGTH lines count)
list(FILTER lines INCLUDE REGEX "error:")
list(LENGTH lines errors)
if(NOT errors EQUAL 1 OR count GREATER 15)
  message(FATAL_ERROR "${errors} errors in ${count} lines, where one in at most 15 says all:\n${output}")
endif()
if(NOT lines MATCHES "${EXPECTED}")
  message(FATAL_ERROR "does not compile, but not because of \"${EXPECTED}\":\n${output}")
endif()
