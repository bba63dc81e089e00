# Headers of others that nearly all files of a library include and that take longer to read than
# the file itself: for target_precompile_headers(). `-D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON` builds
# without, and shows what a file forgot to include.
set(FOVEA_POINT_HEADERS <Eigen/Core> <Eigen/Geometry> <opencv2/core.hpp> <algorithm> <functional>
                        <map> <optional> <string> <vector>)
set(FOVEA_MESSAGE_HEADERS <google/protobuf/message.h> <google/protobuf/util/time_util.h>
                          <grpcpp/grpcpp.h>)

# Headers that many programs share: fovea_shared_headers(name LIBRARIES … HEADERS …), then
# target_precompile_headers(program REUSE_FROM name).
function(fovea_shared_headers name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;HEADERS" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "")
  endif()
  add_library(${name} OBJECT ${source})
  fovea_target(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()
