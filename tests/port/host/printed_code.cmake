# SPDX-License-Identifier: MIT
# Writes the lines of C++ that PROGRAM prints about MESH into OUT.
execute_process(COMMAND ${PROGRAM} ${MESH} --scale 0.001 OUTPUT_VARIABLE printed RESULT_VARIABLE status)
string(FIND "${printed}" "\n// Frame S" from)
if(NOT status EQUAL 0 OR from EQUAL -1)
  message(FATAL_ERROR "batuta-mass prints no C++ about ${MESH}")
endif()
string(SUBSTRING "${printed}" ${from} -1 code)
file(WRITE ${OUT} "${code}")
