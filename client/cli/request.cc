#include "client/cli/request.h"

#include <stdexcept>

#include "client/cli/files.h"
#include "client/cli/parsing.h"
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

v1::CameraIntrinsics ParseIntrinsics(const std::string& text, const std::string& flag) {
  const auto k = ParseNumbers(text, 4, flag, "FX,FY,CX,CY");
  return client::MakeIntrinsics(k[0], k[1], k[2], k[3]);
}

std::optional<DepthCamera> ParseDepthCamera(const std::string& intrinsics,
                                            const std::string& pose) {
  if (intrinsics.empty() && pose.empty()) return std::nullopt;
  if (intrinsics.empty())
    throw std::invalid_argument("--color-from-depth needs --depth-intrinsics");
  if (pose.empty()) throw std::invalid_argument("--depth-intrinsics needs --color-from-depth");
  const auto p = ParseNumbers(pose, 7, "--color-from-depth", "X,Y,Z,QX,QY,QZ,QW");
  return DepthCamera{ParseIntrinsics(intrinsics, "--depth-intrinsics"),
                     client::MakePose(p[0], p[1], p[2], p[3], p[4], p[5], p[6])};
}

std::optional<v1::Vector3> ParseGravity(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto g = ParseNumbers(text, 3, "--gravity", "X,Y,Z");
  v1::Vector3 gravity;
  gravity.set_x(g[0]);
  gravity.set_y(g[1]);
  gravity.set_z(g[2]);
  return gravity;
}

v1::DetectOptions ParseOptions(const std::string& profile,
                               const std::vector<std::string>& changes) {
  v1::DetectOptions options;
  options.set_profile(profile);
  for (const std::string& text : changes) {
    const auto [name, value] = ParseSetting(text);
    (*options.mutable_parameters())[name] = value;
  }
  return options;
}

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
  if (settings.depth_camera) {
    *frame.mutable_depth_intrinsics() = settings.depth_camera->intrinsics;
    *frame.mutable_color_from_depth() = settings.depth_camera->color_from_depth;
  }
  if (settings.gravity) *frame.mutable_gravity() = *settings.gravity;
  *request.mutable_options() = settings.options;
  return request;
}

}  // namespace fovea::cli
