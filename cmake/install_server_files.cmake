# Run by `cmake --install`: configuration and unit of the server. Both follow the prefix, which is
# known only then: /usr belongs to Debian and has its configuration in /etc, any other prefix keeps
# everything below itself.
set(deploy ${CMAKE_CURRENT_LIST_DIR}/../deploy)
get_filename_component(prefix "${CMAKE_INSTALL_PREFIX}" ABSOLUTE BASE_DIR "${CMAKE_BINARY_DIR}")
set(configuration ${prefix}/etc/fovea)
set(program ${prefix}/bin/fovea-server)
if(prefix STREQUAL "/usr")
  set(configuration /etc/fovea)
  set(program fovea-server)
endif()
# What an operator has written there stays.
set(installed $ENV{DESTDIR}${configuration}/fovea-server.toml)
set(name fovea-server.toml)
if(EXISTS ${installed})
  file(SHA256 ${installed} has)
  file(SHA256 ${deploy}/fovea-server.toml brings)
  if(NOT has STREQUAL brings)
    set(name fovea-server.toml.new)
    message(STATUS "Kept as it is: ${installed}; this version's is ${name} beside it")
  endif()
endif()
file(INSTALL ${deploy}/fovea-server.toml DESTINATION ${configuration} RENAME ${name})

file(READ ${deploy}/fovea-server.service unit)
foreach(path program configuration) # in systemd's own words
  string(REPLACE " " "\\x20" ${path} "${${path}}")
endforeach()
string(REPLACE "=fovea-server " "=${program} " unit "${unit}")
string(REPLACE "/etc/fovea/" "${configuration}/" unit "${unit}")
set(units ${prefix}/lib/systemd/system)
file(INSTALL ${deploy}/fovea-server.service DESTINATION ${units})
file(WRITE $ENV{DESTDIR}${units}/fovea-server.service "${unit}")
