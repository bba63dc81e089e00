#include "client/cli/request.h"

#include <stdexcept>

#include "client/cli/files.h"
#include "client/images.h"

namespace fovea::cli {
namespace {

template <typename Make>
auto FromFile(const std::string& path, Make make) {
  try {
    return make(ReadFile(path));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

v1::DetectRequest MakeRequest(const FrameFiles& files, const FrameSettings& settings) {
  v1::DetectRequest request;
  v1::Frame& frame = *request.mutable_frame();
  frame.set_id(files.id);
  *frame.mutable_color() = FromFile(
      files.color_path, [](std::string bytes) { return client::MakeColorImage(std::move(bytes)); });
  *frame.mutable_depth() = FromFile(files.depth_path, [&](std::string bytes) {
    return client::MakeDepthImage(std::move(bytes), settings.depth_unit_m);
  });
  *frame.mutable_intrinsics() = settings.intrinsics;
  if (settings.gravity) *frame.mutable_gravity() = *settings.gravity;
  *request.mutable_options() = settings.options;
  return request;
}

}  // namespace fovea::cli
