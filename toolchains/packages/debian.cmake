# SPDX-License-Identifier: MIT
# A package for Debian, libbatuta-dev: the library, its headers, what ports share, and the files by which CMake finds them.
find_program(BATUTA_GZIP gzip)
find_program(BATUTA_DPKG dpkg)
mark_as_advanced(BATUTA_GZIP BATUTA_DPKG)
if(NOT BATUTA_GZIP OR NOT BATUTA_DPKG)
  return()
endif()
set(name libbatuta-dev)
set(folder ${PROJECT_BINARY_DIR}/debian)
# The one of the manifests (manifests.py).
file(STRINGS ${PROJECT_SOURCE_DIR}/library.properties maintainer REGEX "^maintainer=.+ <.+@.+>$")
if(NOT maintainer)
  message(FATAL_ERROR "library.properties names no maintainer with an address")
endif()
string(REGEX REPLACE "^maintainer=" "" maintainer "${maintainer}")

# What policy asks of every package; a plain `cmake --install` leaves both out.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^MIT License\n\n(Copyright [^\n]*)\n\n" "" terms "${licence}")
string(REGEX MATCH "Copyright [^\n]*" holder "${licence}")
string(REGEX REPLACE "\n\n" "\n.\n" terms "${terms}")
string(REGEX REPLACE "\n" "\n " terms "${terms}")
string(REGEX REPLACE "^Copyright (\\(c\\) )?" "" holder "${holder}")
file(WRITE ${folder}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: batuta

Files: *
Copyright: ${holder}
License: Expat
 ${terms}")
file(READ ${folder}/copyright text)
string(STRIP "${text}" text)
file(WRITE ${folder}/copyright "${text}\n")
file(WRITE ${folder}/changelog "batuta (${PROJECT_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the sources.

 -- ${maintainer}  Thu, 01 Jan 2026 00:00:00 +0000
")
execute_process(COMMAND ${BATUTA_GZIP} -9nf ${folder}/changelog RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${folder}/changelog cannot be packed: ${result}")
endif()
install(FILES ${folder}/copyright ${folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
        COMPONENT debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME ${name})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL development debian)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEBIAN_PACKAGE_NAME ${name})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "collision detection and response of capsules, bounded
 Decides when two moving rigid bodies touch and what happens then, for
 firmware and, with the same bits, for a host. No heap, no exceptions, no
 unbounded loop; its only shape is the capsule. Static libraries, one for
 each room, and the files by which CMake finds them.")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
