#include "fovea/v1/detection_service.pb.h"
#include "server/conversion/frame.h"
#include "server/conversion/options.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::fuzzing {

void FuzzRequest(const std::uint8_t* data, std::size_t size) {
  v1::DetectRequest request;
  if (!request.ParseFromArray(data, static_cast<int>(size))) return;
  Try([&] { server::FromProto(request.frame(), kMaxPixels); });
  Try([&] { server::FromProto(request.options()); });
}

}  // namespace fovea::fuzzing
