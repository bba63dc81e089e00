#include "tests/evaluation/clean_up/client_dialog.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string_view>

#include "fovea/v1/detection_service.pb.h"
#include "server/conversion/gripper.h"

namespace fovea::evaluation {
namespace {

using Json = nlohmann::json;

std::string PngOf(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

Json At(const Json& json, const char* key) { return json.contains(key) ? json[key] : Json(); }

double Number(const Json& json, const char* key) { return json.value(key, 0.0); }

// {"x": …} or [x, y, z].
Eigen::Vector3f Vector(const Json& json) {
  if (json.is_array()) {
    return Eigen::Vector3d(json.at(0), json.at(1), json.at(2)).cast<float>();
  }
  return Eigen::Vector3d(Number(json, "x"), Number(json, "y"), Number(json, "z")).cast<float>();
}

Grasp GraspOf(const Json& json) {
  Grasp grasp;
  grasp.gripper = json.value("gripper_index", std::size_t{0});
  grasp.tool_center_point = Vector(json.at("tool_center_point"));
  grasp.approach = Vector(json.at("approach"));
  grasp.closing = Vector(json.at("closing"));
  grasp.opening_m = static_cast<float>(Number(json, "opening_m"));
  grasp.pre_grasp_opening_m = static_cast<float>(Number(json, "pre_grasp_opening_m"));
  grasp.probability = static_cast<float>(Number(json, "probability"));
  if (!grasp.approach.allFinite() || std::abs(grasp.approach.norm() - 1) > 1e-3F) {
    throw std::invalid_argument("\"approach\" is no unit vector");
  }
  return grasp;
}

// "too low" of "NO_GRASP_REASON_TOO_LOW" or "too_low".
std::string Words(std::string name) {
  constexpr std::string_view kPrefix = "NO_GRASP_REASON_";
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  });
  return name;
}

FoundThing FoundThingOf(const Json& json) {
  const Json box = At(json, "bounding_box");
  FoundThing found = {
      {box.value("x", 0), box.value("y", 0), box.value("width", 0), box.value("height", 0)}, ""};
  for (const Json& none : At(json, "no_grasps")) {
    found.reason += (found.reason.empty() ? "" : ", ") + none.value("gripper", "") + " " +
                    Words(none.value("reason", ""));
  }
  if (!At(json, "grasps").empty()) {
    found.reason += (found.reason.empty() ? "" : ", ") + std::string("tried in vain");
  }
  if (!At(json, "blocked_by").empty()) found.reason = "something stands on it";
  return found;
}

}  // namespace

std::string RequestLine(const scenes::LabelledFrame& frame, const std::vector<Gripper>& hands,
                        const std::string& id) {
  v1::DetectRequest request;
  v1::Frame& proto = *request.mutable_frame();
  proto.set_id(id);
  cv::Mat bgr, depth_mm;
  cv::cvtColor(frame.frame.color_rgb, bgr, cv::COLOR_RGB2BGR);
  cv::Mat depth_m = frame.frame.depth_m.clone();
  depth_m.setTo(0, depth_m != depth_m);
  depth_m.convertTo(depth_mm, CV_16UC1, 1000);
  proto.mutable_color()->set_encoding(v1::COLOR_ENCODING_PNG);
  proto.mutable_color()->set_data(PngOf(bgr));
  proto.mutable_depth()->set_encoding(v1::DEPTH_ENCODING_16UC1_PNG);
  proto.mutable_depth()->set_data(PngOf(depth_mm));
  proto.mutable_intrinsics()->set_fx(frame.frame.intrinsics.fx_px);
  proto.mutable_intrinsics()->set_fy(frame.frame.intrinsics.fy_px);
  proto.mutable_intrinsics()->set_cx(frame.frame.intrinsics.cx_px);
  proto.mutable_intrinsics()->set_cy(frame.frame.intrinsics.cy_px);
  for (const Gripper& hand : hands) {
    *request.mutable_options()->mutable_grasps()->add_grippers() = server::ToProto(hand);
  }
  std::string line;
  if (!google::protobuf::util::MessageToJsonString(request, &line).ok()) {
    throw std::runtime_error("a request has no JSON");
  }
  return line;
}

Decision DecisionOf(const std::string& line) try {
  const Json json = Json::parse(line);
  if (json.contains("grasp")) return GraspOf(json["grasp"]);
  const Json left = json.at("left");
  std::vector<FoundThing> found;
  for (const Json& object : left.is_array() ? left : At(left, "objects")) {
    found.push_back(FoundThingOf(object));
  }
  return found;
} catch (const std::exception& error) {
  constexpr std::size_t kMost = 80;
  throw std::invalid_argument("the program's line \"" + line.substr(0, kMost) +
                              "\" is no decision: " + error.what());
}

}  // namespace fovea::evaluation
