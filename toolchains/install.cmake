# SPDX-License-Identifier: MIT
# find_package(batuta) gives the names that add_subdirectory() gives: batuta::batuta, batuta::config,
# batuta::<room>, batuta::port_<port>.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY BATUTA_ROOMS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/batuta)

install(TARGETS batuta batuta_config ${rooms} batuta_port_${BATUTA_PORT_NAME} EXPORT batuta
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT batuta NAMESPACE batuta:: FILE batutaTargets.cmake DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/batuta)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/batutaConfig.cmake.in
  ${PROJECT_BINARY_DIR}/batutaConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/batutaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/batutaConfig.cmake ${PROJECT_BINARY_DIR}/batutaConfigVersion.cmake
        DESTINATION ${package_folder})
