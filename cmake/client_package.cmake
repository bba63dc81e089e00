# What find_package(fovea) and pkg-config find after `cmake --install`: the client library.
include(CMakePackageConfigHelpers)

set(FOVEA_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fovea)
set_target_properties(grpc_health_proto PROPERTIES POSITION_INDEPENDENT_CODE ON)
set_target_properties(fovea_client PROPERTIES EXPORT_NAME client)
set_target_properties(fovea_proto PROPERTIES EXPORT_NAME proto)
set_target_properties(grpc_health_proto PROPERTIES EXPORT_NAME grpc_health_proto OUTPUT_NAME
                                                   fovea_grpc_health_proto)
# The library's own headers name each other "client/…", its users "fovea/client/…".
target_include_directories(
  fovea_client INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fovea>)
target_compile_features(fovea_client PUBLIC cxx_std_20)

install(TARGETS fovea_client fovea_proto grpc_health_proto EXPORT fovea ARCHIVE COMPONENT dev)
install(EXPORT fovea NAMESPACE fovea:: FILE fovea-targets.cmake DESTINATION ${FOVEA_CONFIG_DIR}
        COMPONENT dev)
if(FOVEA_BUILD_PCL) # of its own: only who asks for it needs PCL
  set_target_properties(fovea_pcl PROPERTIES EXPORT_NAME pcl POSITION_INDEPENDENT_CODE ON)
  install(TARGETS fovea_pcl EXPORT fovea-pcl ARCHIVE COMPONENT dev)
  install(EXPORT fovea-pcl NAMESPACE fovea:: FILE fovea-pcl-targets.cmake
          DESTINATION ${FOVEA_CONFIG_DIR} COMPONENT dev)
endif()
configure_package_config_file(cmake/fovea-config.cmake.in fovea-config.cmake
                              INSTALL_DESTINATION ${FOVEA_CONFIG_DIR})
write_basic_package_version_file(fovea-config-version.cmake COMPATIBILITY SameMinorVersion)
# As far up as it takes: on Debian, below /usr, libraries are in lib/x86_64-linux-gnu.
file(RELATIVE_PATH FOVEA_PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
     ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/fovea.pc.in fovea.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/fovea-config.cmake
              ${PROJECT_BINARY_DIR}/fovea-config-version.cmake DESTINATION ${FOVEA_CONFIG_DIR}
        COMPONENT dev)
install(FILES ${PROJECT_BINARY_DIR}/fovea.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT dev)
