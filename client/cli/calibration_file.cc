#include "client/cli/calibration_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "client/cli/camera_window.h"
#include "client/cli/distortion.h"
#include "client/cli/files.h"
#include "client/cli/parsing.h"
#include "client/cli/realsense_intrinsics.h"
#include "client/images.h"

namespace fovea::cli {
namespace {

double NumberIn(const nlohmann::json& json, const char* name) {
  if (!json.contains(name)) throw std::runtime_error(std::string("it has no ") + name);
  if (!json[name].is_number()) throw std::runtime_error(std::string(name) + " must be a number");
  return json[name];
}

int SideIn(const nlohmann::json& json, const char* name) {
  constexpr double kLargest = 1 << 15;
  const double side = NumberIn(json, name);
  if (side != std::floor(side) || std::abs(side) > kLargest) {
    throw std::runtime_error(std::string(name) + " must be a whole number of pixels");
  }
  return static_cast<int>(side);
}

// As librealsense calls it where others do not.
const char* CentreName(const nlohmann::json& json, const char* name, const char* realsense_name) {
  return !json.contains(name) && json.contains(realsense_name) ? realsense_name : name;
}

// By the names that others give them, too.
std::optional<v1::LensDistortion> DistortionIn(const nlohmann::json& json) {
  const std::string model = json.value("distortion_model", "");
  for (const char* name : {"distortion", "distortion_coefficients", "D", "d"}) {
    if (!json.contains(name)) continue;
    if (!json[name].is_array()) throw std::runtime_error(std::string(name) + " must be numbers");
    return MakeDistortion(model, json[name].get<std::vector<double>>());
  }
  if (json.contains(kCoeffs)) return DistortionOfCoeffs(json);
  if (model.empty()) return std::nullopt;
  throw std::runtime_error("it has a distortion_model (" + model + ") and no distortion");
}

Calibration ParseJson(const nlohmann::json& json) {
  return {.fx = NumberIn(json, "fx"),
          .fy = NumberIn(json, "fy"),
          .cx = NumberIn(json, CentreName(json, "cx", "ppx")),
          .cy = NumberIn(json, CentreName(json, "cy", "ppy")),
          .width = SideIn(json, "width"),
          .height = SideIn(json, "height"),
          .distortion = DistortionIn(json)};
}

YAML::Node Field(const YAML::Node& node, const char* name) {
  const YAML::Node field = node.IsMap() ? node[name] : YAML::Node();
  if (!field || field.IsNull()) throw std::runtime_error(std::string("it has no ") + name);
  return field;
}

// `coefficients` may be missing.
std::optional<v1::LensDistortion> DistortionOf(const YAML::Node& yaml,
                                               const YAML::Node& coefficients) {
  if (!coefficients || coefficients.IsNull()) return std::nullopt;
  const YAML::Node model = yaml["distortion_model"];
  return MakeDistortion(model && !model.IsNull() ? model.as<std::string>() : "",
                        coefficients.as<std::vector<double>>());
}

Calibration FromMatrix(const YAML::Node& node, const char* name) {
  const auto matrix = node.as<std::vector<double>>();
  if (matrix.size() != 9) throw std::runtime_error(std::string(name) + " must have 9 numbers");
  constexpr double kMostSkew_px = 1;
  const auto is_none = [&](int place) { return std::abs(matrix[place]) < kMostSkew_px; };
  if (!(is_none(1) && is_none(3) && is_none(6) && is_none(7))) {
    throw std::runtime_error(std::string(name) +
                             " is not fx 0 cx, 0 fy cy, 0 0 1, row by row (skew is not supported)");
  }
  Calibration calibration;
  calibration.fx = matrix[0];
  calibration.fy = matrix[4];
  calibration.cx = matrix[2];
  calibration.cy = matrix[5];
  return calibration;
}

CameraWindow WindowOf(const YAML::Node& yaml) {
  const auto number = [](const YAML::Node& node, const char* name) {
    const YAML::Node field = node.IsMap() ? node[name] : YAML::Node();
    return field && !field.IsNull() ? field.as<std::uint32_t>() : 0;
  };
  CameraWindow window{number(yaml, "binning_x"), number(yaml, "binning_y")};
  if (const YAML::Node roi = yaml["roi"]) {
    window.x_offset = number(roi, "x_offset");
    window.y_offset = number(roi, "y_offset");
    window.width = number(roi, "width");
    window.height = number(roi, "height");
  }
  return window;
}

// A message; ROS 1 writes K and D.
Calibration ParseCameraInfo(const YAML::Node& yaml) {
  const bool is_ros2 = static_cast<bool>(yaml["k"]);
  Calibration calibration = FromMatrix(Field(yaml, is_ros2 ? "k" : "K"), is_ros2 ? "k" : "K");
  calibration.width = Field(yaml, "width").as<int>();
  calibration.height = Field(yaml, "height").as<int>();
  Apply(WindowOf(yaml), &calibration);
  calibration.distortion = DistortionOf(yaml, yaml[is_ros2 ? "d" : "D"]);
  return calibration;
}

Calibration ParseRos(const std::string& text) {
  const YAML::Node yaml = YAML::Load(text);
  if (!yaml.IsMap()) {
    throw std::runtime_error("it is neither FX,FY,CX,CY nor YAML or JSON of a camera");
  }
  if (yaml["k"] || yaml["K"]) return ParseCameraInfo(yaml);
  Calibration calibration =
      FromMatrix(Field(Field(yaml, "camera_matrix"), "data"), "camera_matrix");
  calibration.width = Field(yaml, "image_width").as<int>();
  calibration.height = Field(yaml, "image_height").as<int>();
  if (const YAML::Node distortion = yaml["distortion_coefficients"]) {
    calibration.distortion = DistortionOf(yaml, Field(distortion, "data"));
  }
  return calibration;
}

Calibration ParseLine(const std::string& text) {
  const std::string line = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  constexpr std::size_t kLongest = 200;
  if (line.size() > kLongest || line.find_first_of("\r\n") != std::string::npos) {
    throw std::runtime_error("its numbers are more than one line FX,FY,CX,CY");
  }
  const auto k = ParseNumbers(line, 4, "its text", "FX,FY,CX,CY");
  return CalibrationOf(client::MakeIntrinsics(k[0], k[1], k[2], k[3]), {});
}

void Check(const Calibration& c) {
  if (!IsCamera(c)) {
    throw std::runtime_error("focal lengths must be above 0 and all numbers finite");
  }
}

void CheckSize(const Calibration& c) {
  if (c.width <= 0 || c.height <= 0) throw std::runtime_error("width and height must be above 0");
}

Calibration Parse(const std::string& text) {
  const char first = text[std::min(text.find_first_not_of(" \t\r\n"), text.size() - 1)];
  const bool is_list = text.find(':') == std::string::npos && text.find(',') != std::string::npos;
  if ((first >= '0' && first <= '9') || first == '.' || (first == '-' && is_list)) {
    return ParseLine(text);
  }
  const auto json = first == '{' ? nlohmann::json::parse(text) : nlohmann::json();
  const bool is_ours = json.is_object() && !json.contains("k") && !json.contains("K");
  // JSON is YAML, too.
  Calibration calibration = is_ours ? ParseJson(json) : ParseRos(text);
  CheckSize(calibration);
  return calibration;
}

}  // namespace

v1::CameraIntrinsics IntrinsicsOf(const Calibration& c) {
  v1::CameraIntrinsics intrinsics = client::MakeIntrinsics(c.fx, c.fy, c.cx, c.cy);
  if (c.distortion) *intrinsics.mutable_distortion() = *c.distortion;
  return intrinsics;
}

Calibration CalibrationOf(const v1::CameraIntrinsics& k, const cv::Size& size) {
  Calibration calibration{.fx = k.fx(),
                          .fy = k.fy(),
                          .cx = k.cx(),
                          .cy = k.cy(),
                          .width = size.width,
                          .height = size.height,
                          .distortion = {}};
  if (k.has_distortion()) calibration.distortion = k.distortion();
  return calibration;
}

Calibration ReadCalibration(const std::string& path) {
  std::string text = ReadFile(path, kLargestText);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  try {
    Calibration calibration = Parse(text);
    Check(calibration);
    return calibration;
  } catch (const std::exception& error) {
    throw std::runtime_error("calibration file " + path + ": " + error.what());
  }
}

std::string ToCalibrationJson(const Calibration& c) {
  nlohmann::ordered_json json{{"fx", c.fx}, {"fy", c.fy}, {"cx", c.cx}, {"cy", c.cy}};
  if (c.width > 0) json.update({{"width", c.width}, {"height", c.height}});
  if (c.distortion) {
    const auto& numbers = c.distortion->coefficients();
    json["distortion_model"] = ModelName(*c.distortion);
    json["distortion"] = std::vector<double>(numbers.begin(), numbers.end());
  }
  return json.dump(1) + "\n";
}

}  // namespace fovea::cli
