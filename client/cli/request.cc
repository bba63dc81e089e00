#include "client/cli/request.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/bundle/changed_options.h"
#include "client/bundle/readable_files.h"
#include "client/cli/files.h"
#include "client/cli/intrinsics_flag.h"
#include "client/cli/parsing.h"
#include "client/images.h"

namespace fovea::cli {
namespace {

template <typename Make>
auto FromFile(const std::string& path, const std::function<std::string()>& read, Make make) {
  try {
    return make(read ? read() : ReadFile(path));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

// `expected`: what the calibration file says; empty = nothing.
void RequireSize(const char* flag, const std::string& file, const cv::Size& expected,
                 const cv::Size& size) {
  if (expected.empty() || expected == size) return;
  throw std::runtime_error(fmt::format("{}: {} is for images of {}x{}, this one has {}x{}", flag,
                                       file, expected.width, expected.height, size.width,
                                       size.height));
}

// What messages can hold of a file's name, which may be of any bytes.
std::string Utf8(const std::string& name) {
  using nlohmann::json;
  return json::parse(json(name).dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

std::optional<v1::Pose> ParsePose(const std::string& text, const std::string& flag) {
  if (text.empty()) return std::nullopt;
  const auto p = ParseNumbers(text, 7, flag, "X,Y,Z,QX,QY,QZ,QW");
  return client::MakePose(p[0], p[1], p[2], p[3], p[4], p[5], p[6]);
}

std::optional<DepthCamera> ParseDepthCamera(const std::string& intrinsics,
                                            const std::string& pose) {
  if (intrinsics.empty() && pose.empty()) return std::nullopt;
  if (intrinsics.empty())
    throw std::invalid_argument("--color-from-depth needs --depth-intrinsics");
  if (pose.empty()) throw std::invalid_argument("--depth-intrinsics needs --color-from-depth");
  const std::optional<v1::Pose> color_from_depth = ParsePose(pose, "--color-from-depth");
  const GivenIntrinsics given = ReadIntrinsics(intrinsics, "--depth-intrinsics");
  return DepthCamera{given.values, *color_from_depth, given.size, given.path};
}

void CheckDepthSize(const DepthCamera& camera, const cv::Size& size) {
  RequireSize("--depth-intrinsics", camera.intrinsics_path, camera.size, size);
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

v1::DetectRequest CommonRequest(const FrameSettings& settings) {
  v1::DetectRequest request;
  v1::Frame& frame = *request.mutable_frame();
  frame.mutable_depth()->set_unit_m(settings.depth_unit_m);
  *frame.mutable_intrinsics() = settings.intrinsics;
  if (settings.depth_camera) {
    *frame.mutable_depth_intrinsics() = settings.depth_camera->intrinsics;
    *frame.mutable_color_from_depth() = settings.depth_camera->color_from_depth;
  }
  if (settings.gravity) *frame.mutable_gravity() = *settings.gravity;
  if (settings.camera_pose) *frame.mutable_camera_pose() = *settings.camera_pose;
  *request.mutable_options() = settings.options;
  return request;
}

void CheckSize(const FrameSettings& settings, const v1::Detections& detections) {
  const cv::Size size(static_cast<int>(detections.width()), static_cast<int>(detections.height()));
  if (!settings.info_topic.empty() && !settings.size.empty() && settings.size != size) {
    throw ErrorOfAllFrames(fmt::format(
        "{}: it is for images of {}x{}, colour has {}x{}; give --intrinsics instead",
        settings.info_topic, settings.size.width, settings.size.height, size.width, size.height));
  }
  RequireSize("--intrinsics", settings.intrinsics_path, settings.size, size);
}

FrameSettings SettingsFor(const FrameFiles& files, const FrameSettings& settings) {
  if (!files.sent_before) return settings;
  const v1::Frame& sent = files.sent_before->request.frame();
  FrameSettings own = settings;
  own.intrinsics = sent.intrinsics();
  own.depth_unit_m = bundle::UnitOf(sent.depth());
  own.depth_camera.reset();
  if (sent.has_depth_intrinsics()) {
    own.depth_camera = DepthCamera{sent.depth_intrinsics(), sent.color_from_depth()};
  }
  return own;
}

v1::DetectRequest MakeRequest(const FrameFiles& files, const FrameSettings& settings) {
  if (files.sent_before) {
    v1::DetectRequest request = files.sent_before->request;
    bundle::ChangeOptions(settings.options, request.mutable_options());
    return request;
  }
  v1::DetectRequest request = CommonRequest(settings);
  v1::Frame& frame = *request.mutable_frame();
  frame.set_id(Utf8(files.id));
  if (files.captured_at) *frame.mutable_captured_at() = *files.captured_at;
  *frame.mutable_color() = FromFile(files.color_path, files.read_color, [](std::string bytes) {
    return client::MakeColorImage(std::move(bytes));
  });
  *frame.mutable_depth() = FromFile(files.depth_path, files.read_depth, [&](std::string bytes) {
    if (settings.depth_camera && !settings.depth_camera->size.empty()) {
      CheckDepthSize(*settings.depth_camera, DecodeDepth(bytes, files.depth_path).size());
    }
    return client::MakeDepthImage(std::move(bytes), settings.depth_unit_m);
  });
  return request;
}

}  // namespace fovea::cli
