# `make package`: fovea-server, fovea-client and python3-fovea as Debian packages.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Fovea)
set(CPACK_PACKAGE_CONTACT "Fovea <fovea@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
# Through DESTDIR, since the configuration is in /etc, not below the prefix.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL server client python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

set(CPACK_DEBIAN_SERVER_PACKAGE_NAME fovea-server)
set(CPACK_COMPONENT_SERVER_DESCRIPTION "The service that detects unknown objects in RGB-D frames.")
set(CPACK_DEBIAN_SERVER_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_SERVER_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/deploy/debian/server/conffiles
                                              ${PROJECT_SOURCE_DIR}/deploy/debian/server/postinst
                                              ${PROJECT_SOURCE_DIR}/deploy/debian/server/prerm)

set(CPACK_DEBIAN_CLIENT_PACKAGE_NAME fovea-client)
set(CPACK_COMPONENT_CLIENT_DESCRIPTION
    "Command line, camera client and C++ library for fovea, which detects unknown objects in RGB-D\
 frames.")
set(CPACK_DEBIAN_CLIENT_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CLIENT_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CLIENT_PACKAGE_SUGGESTS "libgrpc++-dev, libprotobuf-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fovea)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "Python client of fovea, which detects unknown objects in RGB-D frames.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3:any, python3-grpcio, python3-protobuf, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/deploy/debian/python/postinst
                                              ${PROJECT_SOURCE_DIR}/deploy/debian/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pil, python3-zstandard")

install(FILES deploy/fovea-server.service DESTINATION lib/systemd/system COMPONENT server)
install(FILES deploy/fovea-server.toml DESTINATION /etc/fovea COMPONENT server)
foreach(package fovea-server:server fovea-client:client python3-fovea:python)
  string(REPLACE ":" ";" package ${package})
  list(GET package 0 name)
  list(GET package 1 component)
  install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
          COMPONENT ${component})
endforeach()
include(CPack)
