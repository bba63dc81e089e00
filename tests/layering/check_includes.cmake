# Fails if a file includes what its folder must not know.
# usage: cmake -DROOT=<project> -P check_includes.cmake

# forbid(FOLDER PATTERN WHY [EXCEPT]): no source below FOLDER, but for those below FOLDER/EXCEPT, may
# have an #include that matches PATTERN.
function(forbid folder pattern why)
  file(GLOB_RECURSE sources ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cc)
  if(ARGC GREATER 3)
    list(FILTER sources EXCLUDE REGEX "^${ROOT}/${folder}/${ARGV3}/")
  endif()
  if(NOT sources)
    message(SEND_ERROR "${folder} holds no sources: is the rule out of date?")
  endif()
  foreach(source ${sources})
    file(STRINGS ${source} bad REGEX "^ *#include [<\"](${pattern})")
    if(bad)
      file(RELATIVE_PATH name ${ROOT} ${source})
      message(SEND_ERROR "${name}: ${why}: ${bad}")
    endif()
  endforeach()
endfunction()

forbid(core "grpc|google/protobuf|fovea/v1/|server/|client/|tests/" "the core knows no service")
forbid(core "opencv2/(imgcodecs|highgui)|fstream|filesystem|spdlog|iostream" "the core has no files, windows or logs")
# Folders of core are stages, but for the paper's method, which is a detector; of what stands above
# them lens knows trace.h.
file(GLOB stages RELATIVE ${ROOT}/core ${ROOT}/core/*)
list(FILTER stages EXCLUDE REGEX "[.]|^paper$")
foreach(stage ${stages})
  forbid(core/${stage} "core/([a-su-z][a-z_]*[.]h|paper/)" "stages do not know the detector")
endforeach()
forbid(core/types "core/([a-su-z]|t[^y])" "types stand at the bottom")
forbid(core/segmentation "core/(scene|seeds|objects)/" "segmentation knows neither the scene nor what is found in it")
forbid(core/scene "core/(seeds|objects)/" "the scene knows nothing of what is found in it")
forbid(flags "core/|proto/|fovea/|server/|client/|tests/|grpc|opencv2/" "flags know no programs")
forbid(core "flags/" "the core has no command line")
forbid(client "core/|server/|tests/" "the client knows neither core nor server")
forbid(client "opencv2/imgcodecs" "what it needs is too much for a robot: client/image_files")
forbid(client "pcl/|client/pcl/" "only fovea::pcl and its example know PCL" "(examples/)?pcl")
forbid(core "pcl/" "PCL's headers cost each file a second")
forbid(server "client/|tests/" "the server knows no client")
