# SPDX-License-Identifier: MIT
# Sections of the report, each a program batuta_report_<section> that writes its CSV, and the targets that run them all and
# draw: run-report (quick, what CI runs) and report-full.

# What a section stands on: command line, CSV, histograms, timing.
add_library(batuta_report STATIC options.cpp histogram.cpp table.cpp timing.cpp)
target_include_directories(batuta_report PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(batuta_report PUBLIC batuta::batuta batuta_test_support PRIVATE batuta_warnings)

# batuta_report_section(<name> SOURCES <file>... [LIBS <target>...])
function(batuta_report_section name)
  cmake_parse_arguments(SECTION "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(batuta_report_${name} ${SECTION_SOURCES})
  target_link_libraries(batuta_report_${name} PRIVATE batuta_report batuta_warnings ${SECTION_LIBS})
endfunction()

set(folder ${PROJECT_SOURCE_DIR}/build/report)
set(programs "")
set(files "")
foreach(section search peers misses climb swept response friction stiff flight simulation haptics growth worlds costs motion)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${section}/CMakeLists.txt)
    add_subdirectory(${section})
  endif()
  if(TARGET batuta_report_${section})
    list(APPEND programs batuta_report_${section})
    list(APPEND files $<TARGET_FILE:batuta_report_${section}>)
    add_test(NAME report.${section}_ShardsMergeToTheWhole
             COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/report_test.py $<TARGET_FILE:batuta_report_${section}>)
  endif()
endforeach()

set(run ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/run.py)
add_custom_target(run-report COMMAND ${run} ${folder} quick ${files} DEPENDS ${programs} USES_TERMINAL VERBATIM
  COMMENT "Report of error against run time, quick, into build/report: about a minute")
add_custom_target(report-full COMMAND ${run} ${folder}/full full ${files} DEPENDS ${programs} USES_TERMINAL VERBATIM
  COMMENT "Report of error against run time, full, into build/report/full: about an hour; each section says its part")

# What pages of the repository show of the quick report, as FILE:MARK. `cmake --build build/host --target readme-report` runs
# it and writes these blocks and their pictures, unless the host was busy; where a report has been run, the test holds the
# blocks against it, but for the times.
set(blocks docs/error.md:report docs/error.md:beat docs/error.md:phrase docs/error.md:flight docs/error.md:motion)
set(readme ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/readme.py ${PROJECT_SOURCE_DIR} --report ${folder} ${blocks})
add_custom_target(readme-report COMMAND ${readme} --update DEPENDS run-report VERBATIM
                  COMMENT "docs/error.md: tables and pictures from the quick report")
add_test(NAME report.Readme_ShowsTheReport COMMAND ${readme})
set_tests_properties(report.Readme_ShowsTheReport PROPERTIES SKIP_RETURN_CODE 77)

batuta_test(report SOURCES histogram_test.cpp options_test.cpp timing_test.cpp LIBS batuta_report)
add_test(NAME report.Merge_AddsUpAndRefuses COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/render_test.py)
