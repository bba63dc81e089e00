# Run by `cmake --install`: configuration and unit of the server. Both follow the prefix, which is
# known only then: /usr belongs to Debian and has its configuration in /etc, any other prefix keeps
# everything below itself.
set(deploy ${CMAKE_CURRENT_LIST_DIR}/../deploy)
set(configuration ${CMAKE_INSTALL_PREFIX}/etc/fovea)
set(program ${CMAKE_INSTALL_PREFIX}/bin/fovea-server)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(configuration /etc/fovea)
  set(program fovea-server)
endif()
file(INSTALL ${deploy}/fovea-server.toml DESTINATION ${configuration})

file(READ ${deploy}/fovea-server.service unit)
string(REPLACE "=fovea-server " "=${program} " unit "${unit}")
string(REPLACE "/etc/fovea/" "${configuration}/" unit "${unit}")
set(units ${CMAKE_INSTALL_PREFIX}/lib/systemd/system)
file(INSTALL ${deploy}/fovea-server.service DESTINATION ${units})
file(WRITE $ENV{DESTDIR}${units}/fovea-server.service "${unit}")
