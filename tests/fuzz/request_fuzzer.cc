#include <google/protobuf/stubs/logging.h>

#include "fovea/v1/detection_service.pb.h"
#include "server/conversion/frame.h"
#include "server/conversion/options.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

// Else it writes a line for each name that is not UTF-8.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  google::protobuf::SetLogHandler(nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  v1::DetectRequest request;
  if (!request.ParseFromArray(data, static_cast<int>(size))) return 0;
  fuzzing::Try([&] { server::FromProto(request.frame(), fuzzing::kMaxPixels); });
  fuzzing::Try([&] { server::FromProto(request.options()); });
  return 0;
}
