# SPDX-License-Identifier: MIT
# Compiles FILE and fails unless: EXPECTED is empty and it compiles, or it does not and EXPECTED is in the message.
execute_process(COMMAND ${COMPILER} @${FLAG_FILE} ${FLAGS} -fsyntax-only ${FILE}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(EXPECTED STREQUAL "")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "must compile, but does not:\n${output}")
  endif()
  return()
endif()
if(result EQUAL 0)
  message(FATAL_ERROR "must not compile, but does")
endif()
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "does not compile, but not because of \"${EXPECTED}\":\n${output}")
endif()
