# Manual pages from what the programs say with --help, and from man_pages/TARGET.h2m, which has their
# exit status.
find_program(HELP2MAN help2man REQUIRED)
find_program(GZIP gzip REQUIRED)

# A page PAGE(SECTION) of TARGET, or of its subcommand, installed with COMPONENT.
function(fovea_man_page target page section component description)
  set(folder ${PROJECT_BINARY_DIR}/man)
  set(output ${folder}/${page}.${section}.gz)
  set(more ${PROJECT_SOURCE_DIR}/cmake/man_pages/${target}.h2m)
  # Named as the page, which is what help2man calls the program.
  file(GENERATE OUTPUT ${folder}/${page}
       CONTENT "#!/bin/sh\nexec \"$<TARGET_FILE:${target}>\" ${ARGN} \"$@\"\n"
       FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  add_custom_command(
    OUTPUT ${output}
    COMMAND
      ${HELP2MAN} --no-info --section ${section} --name ${description} --version-string
      ${PROJECT_VERSION} --include ${more} --output ${page}.${section} ./${page}
    COMMAND ${GZIP} -9nf ${page}.${section}
    DEPENDS ${target} ${folder}/${page} ${more}
    WORKING_DIRECTORY ${folder}
    COMMENT "Writing ${page}(${section})"
    VERBATIM)
  add_custom_target(man_${page} ALL DEPENDS ${output})
  install(FILES ${output} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section}
          COMPONENT ${component})
endfunction()

fovea_man_page(fovea-server fovea-server 8 server "detects unknown objects in RGB-D frames")
fovea_man_page(fovea fovea 1 client "asks a fovea server for objects")
fovea_man_page(fovea fovea-detect 1 client "detects the objects of a frame or a folder" detect)
fovea_man_page(fovea-observer fovea-observer 1 observer "serves a page that shows what robots see")
if(FOVEA_BUILD_CAPTURE)
  fovea_man_page(fovea-capture fovea-capture 1 capture "streams an RGB-D camera to a fovea server")
  fovea_man_page(fovea-capture fovea-capture-devices 1 capture "lists RGB-D cameras" devices)
  fovea_man_page(fovea-capture fovea-capture-record 1 capture "records an RGB-D camera" record)
  fovea_man_page(fovea-capture fovea-capture-replay 1 capture "detects in a recording" replay)
endif()
