# SPDX-License-Identifier: MIT
# batuta as a component of ESP-IDF, whose build includes the CMakeLists.txt of the root. Eigen comes with the manifest,
# idf_component.yml, as a public dependency. The application supplies batuta_trap() (core/assert.hpp).
include(${CMAKE_CURRENT_LIST_DIR}/files.cmake)
idf_component_register(SRCS ${BATUTA_SOURCES} INCLUDE_DIRS include)
target_compile_definitions(${COMPONENT_LIB} PUBLIC BATUTA_WITH_DOUBLE=0 PRIVATE ${BATUTA_CORE_DEFINITIONS})
target_compile_options(${COMPONENT_LIB} PUBLIC ${BATUTA_FLAGS} PRIVATE ${BATUTA_CORE_FLAGS})
