# `make package`: fovea-server, fovea-client, fovea-observer, fovea-capture, libfovea-dev and
# python3-fovea.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Fovea)
set(CPACK_PACKAGE_CONTACT "Fovea maintainers <maintainers@fovea.invalid>")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_release.cmake)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
# Through DESTDIR, since the configuration is in /etc, not below the prefix.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# As Debian wants those of maintainer scripts, whatever umask the clone was made with.
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What a package is in one line is the first one of its own description below.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_COMPONENTS_ALL server client observer dev python)
set(FOVEA_ABOUT "Fovea tells robots what unknown objects are in front of them: a robot with an RGB-D
camera sends a frame over gRPC, and the answer is the objects in it, with masks, boxes, sizes and a
first grasp.")
string(REPLACE "\n" " " FOVEA_ABOUT ${FOVEA_ABOUT})

set(CPACK_DEBIAN_SERVER_PACKAGE_NAME fovea-server)
set(CPACK_COMPONENT_SERVER_DESCRIPTION "service that detects unknown objects in RGB-D frames
${FOVEA_ABOUT} This is the service.")
set(CPACK_DEBIAN_SERVER_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_SERVER_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/deploy/debian/server/conffiles
    ${PROJECT_SOURCE_DIR}/deploy/debian/server/postinst
    ${PROJECT_SOURCE_DIR}/deploy/debian/server/prerm
    ${PROJECT_SOURCE_DIR}/deploy/debian/server/postrm)

set(CPACK_DEBIAN_CLIENT_PACKAGE_NAME fovea-client)
set(CPACK_COMPONENT_CLIENT_DESCRIPTION "command line of fovea, which detects unknown objects
${FOVEA_ABOUT} This is the command line: files in, pictures, JSON and clouds out.")
set(CPACK_DEBIAN_CLIENT_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CLIENT_PACKAGE_SECTION science)

set(CPACK_DEBIAN_OBSERVER_PACKAGE_NAME fovea-observer)
set(CPACK_COMPONENT_OBSERVER_DESCRIPTION "page of fovea, which detects unknown objects
${FOVEA_ABOUT} This serves a page that shows what robots see and what is found in it.")
set(CPACK_DEBIAN_OBSERVER_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_OBSERVER_PACKAGE_SECTION science)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libfovea-dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION "C++ client library of fovea, which detects unknown objects
${FOVEA_ABOUT} This is the client library, with its headers and the wire contract.")
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
# gRPC's CMake files want the last one to be there.
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libgrpc++-dev, libgrpc-dev, libprotobuf-dev, protobuf-compiler-grpc")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libpcl-dev") # of fovea::pcl
# fovea-client had these files before.
set(CPACK_DEBIAN_DEV_PACKAGE_BREAKS "fovea-client (<< 0.1.0-1)")
set(CPACK_DEBIAN_DEV_PACKAGE_REPLACES "fovea-client (<< 0.1.0-1)")

if(FOVEA_BUILD_CAPTURE)
  list(APPEND CPACK_COMPONENTS_ALL capture)
  set(CPACK_DEBIAN_CAPTURE_PACKAGE_NAME fovea-capture)
  set(CPACK_COMPONENT_CAPTURE_DESCRIPTION "camera client of fovea, which detects unknown objects
${FOVEA_ABOUT} This streams a camera that OpenNI2 opens, records it, and shows what is found.")
  set(CPACK_DEBIAN_CAPTURE_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_CAPTURE_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_CAPTURE_PACKAGE_BREAKS "fovea-client (<< 0.1.0-1)")
  set(CPACK_DEBIAN_CAPTURE_PACKAGE_REPLACES "fovea-client (<< 0.1.0-1)")
endif()

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fovea)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python client of fovea, which detects unknown objects
${FOVEA_ABOUT} This is the Python library.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3:any, python3-grpcio, python3-protobuf, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/deploy/debian/python/postinst
                                              ${PROJECT_SOURCE_DIR}/deploy/debian/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pil, python3-zstandard")

install(SCRIPT cmake/install_server_files.cmake COMPONENT server)

# bash looks for a file with the command's name.
set(COMPLETIONS ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
foreach(command fovea-server:server fovea:client fovea-observer:observer fovea-capture:capture)
  string(REPLACE ":" ";" command ${command})
  list(GET command 0 name)
  list(GET command 1 component)
  install(FILES deploy/completion/fovea RENAME ${name} DESTINATION ${COMPLETIONS}
          COMPONENT ${component})
endforeach()

# What Debian wants to find in /usr/share/doc of every package.
add_custom_command(
  OUTPUT ${PROJECT_BINARY_DIR}/changelog.gz
  COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${PROJECT_BINARY_DIR}/changelog.gz
  DEPENDS CHANGELOG.md)
add_custom_target(
  changelogs ALL
  COMMAND
    ${CMAKE_COMMAND} -D VERSION=${PROJECT_VERSION} -D
    CPACK_DEBIAN_PACKAGE_RELEASE=${CPACK_DEBIAN_PACKAGE_RELEASE} -D
    CPACK_PACKAGE_CONTACT=${CPACK_PACKAGE_CONTACT} -D GZIP=${GZIP} -P
    ${PROJECT_SOURCE_DIR}/cmake/debian_changelog.cmake
  BYPRODUCTS ${PROJECT_BINARY_DIR}/changelog.Debian.gz
  DEPENDS ${PROJECT_BINARY_DIR}/changelog.gz
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  VERBATIM)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES deploy/debian/copyright ${PROJECT_BINARY_DIR}/changelog.gz
                ${PROJECT_BINARY_DIR}/changelog.Debian.gz DESTINATION ${folder}
          COMPONENT ${component})
endforeach()
include(CPack)
