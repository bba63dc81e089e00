# Run with each build: changelog.Debian.gz, here, of the version that packages of this commit have.
# usage: cmake -D VERSION=… -D CPACK_DEBIAN_PACKAGE_RELEASE=… -D CPACK_PACKAGE_CONTACT=… -D GZIP=… -P
# debian_changelog.cmake
include(${CMAKE_CURRENT_LIST_DIR}/package_release.cmake)
set(FOVEA_DEBIAN_VERSION ${VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian)
configure_file(${CMAKE_CURRENT_LIST_DIR}/../deploy/debian/changelog.in ${changelog} @ONLY)
if(${changelog} IS_NEWER_THAN ${changelog}.gz)
  execute_process(COMMAND ${GZIP} -9nc ${changelog} OUTPUT_FILE ${changelog}.gz
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
