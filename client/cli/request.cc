#include "client/cli/request.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

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

// METRES or METRES,LEAST: the least probability of what is returned.
double ParseHand(const std::string& text, const std::string& form, v1::Gripper* gripper) {
  const std::size_t count = text.find(',') == std::string::npos ? 1 : 2;
  const auto numbers = ParseNumbers(text, count, "--gripper", form);
  if (count == 2) gripper->set_min_probability(numbers.back());
  if (!(numbers.front() > 0)) {  // in the contract 0 stands for the usual length
    throw std::invalid_argument("--gripper: \"" + text + "\" is not a length above 0 metres");
  }
  return numbers.front();
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

std::optional<DepthCamera> ParseDepthCamera(const std::string& intrinsics,
                                            const std::string& pose) {
  if (intrinsics.empty() && pose.empty()) return std::nullopt;
  if (intrinsics.empty())
    throw std::invalid_argument("--color-from-depth needs --depth-intrinsics");
  if (pose.empty()) throw std::invalid_argument("--depth-intrinsics needs --color-from-depth");
  const auto p = ParseNumbers(pose, 7, "--color-from-depth", "X,Y,Z,QX,QY,QZ,QW");
  const GivenIntrinsics given = ReadIntrinsics(intrinsics, "--depth-intrinsics");
  return DepthCamera{given.values, client::MakePose(p[0], p[1], p[2], p[3], p[4], p[5], p[6]),
                     given.size, given.path};
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

void ParseGrippers(const std::vector<std::string>& texts, v1::DetectOptions* options) {
  for (const std::string& text : texts) {
    if (text == "none") {
      options->mutable_grasps()->set_none(true);
      continue;
    }
    v1::Gripper& gripper = *options->mutable_grasps()->add_grippers();
    gripper.set_name(text);
    const std::string form =
        "jaw=OPENING or suction=DIAMETER in metres, with ,LEAST probability or without, or none";
    if (text.starts_with("jaw=")) {
      gripper.mutable_jaw()->set_max_opening_m(ParseHand(text.substr(4), form, &gripper));
    } else if (text.starts_with("suction=")) {
      gripper.mutable_suction()->set_diameter_m(ParseHand(text.substr(8), form, &gripper));
    } else {
      throw std::invalid_argument(
          std::string("--gripper: \"").append(text).append("\" is not ").append(form));
    }
  }
}

void ParsePlace(const std::string& text, v1::DetectOptions* options) {
  if (text.empty()) return;
  const auto size = ParseNumbers(text, 3, "--place", "LENGTH,WIDTH,HEIGHT in metres");
  v1::Vector3& wanted = *options->mutable_places()->mutable_size();
  wanted.set_x(size[0]);
  wanted.set_y(size[1]);
  wanted.set_z(size[2]);
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
  *request.mutable_options() = settings.options;
  return request;
}

void CheckSize(const FrameSettings& settings, const v1::Detections& detections) {
  const cv::Size size(static_cast<int>(detections.width()), static_cast<int>(detections.height()));
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
    request.mutable_options()->clear_tracking();  // there is no stream
    request.mutable_options()->MergeFrom(settings.options);
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
