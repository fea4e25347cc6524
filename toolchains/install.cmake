# SPDX-License-Identifier: MIT
# find_package(batuta) gives the names that add_subdirectory() gives: batuta::batuta, batuta::config,
# batuta::<room>, batuta::port_<port>, and what ports share: batuta::link, firmware, pid, usb_stick, simulated. Programs where they are built.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY BATUTA_ROOMS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/batuta)

set(parts)
foreach(part link firmware pid usb_stick simulated)
  if(TARGET batuta_${part})
    list(APPEND parts batuta_${part})
  endif()
endforeach()
if(BATUTA_PORT)
  list(APPEND parts batuta_port_${BATUTA_PORT_NAME})
endif()
install(TARGETS batuta batuta_config ${rooms} ${parts} EXPORT batuta
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT batuta NAMESPACE batuta:: FILE batutaTargets.cmake DESTINATION ${package_folder} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
# Headers of port/ are included by their path in it: "shared/link/frame.hpp". Of a USB stick there is as well what is compiled
# where TinyUSB is: its callbacks, and its configuration (shared/usb_stick/usb_stick.md).
install(DIRECTORY ${PROJECT_SOURCE_DIR}/port/shared DESTINATION ${BATUTA_PORT_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.hpp" PATTERN "tusb_config.h" PATTERN "tinyusb_device.cpp")
if(BATUTA_PORT STREQUAL "host")
  install(FILES ${PROJECT_SOURCE_DIR}/port/platforms/host/clock.hpp DESTINATION ${BATUTA_PORT_INCLUDEDIR}/platforms/host
          COMPONENT development)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/batuta COMPONENT licence)

foreach(program duel answer feel mass)
  if(TARGET batuta-${program})
    install(TARGETS batuta-${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  endif()
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/batutaConfig.cmake.in
  ${PROJECT_BINARY_DIR}/batutaConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/batutaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/batutaConfig.cmake ${PROJECT_BINARY_DIR}/batutaConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  include(${CMAKE_CURRENT_LIST_DIR}/packages/debian.cmake)
endif()
