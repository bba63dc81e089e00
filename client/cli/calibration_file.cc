#include "client/cli/calibration_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "client/cli/files.h"
#include "client/cli/parsing.h"

namespace fovea::cli {
namespace {

Calibration ParseJson(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  return {.fx = json.at("fx"),
          .fy = json.at("fy"),
          .cx = json.at("cx"),
          .cy = json.at("cy"),
          .width = json.at("width"),
          .height = json.at("height")};
}

YAML::Node Field(const YAML::Node& node, const char* name) {
  const YAML::Node field = node.IsMap() ? node[name] : YAML::Node();
  if (!field || field.IsNull()) throw std::runtime_error(std::string("it has no ") + name);
  return field;
}

bool IsDistorted(const YAML::Node& coefficients) {
  if (!coefficients || coefficients.IsNull()) return false;
  const auto values = coefficients.as<std::vector<double>>();
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
}

Calibration FromMatrix(const YAML::Node& node, const char* name) {
  const auto matrix = node.as<std::vector<double>>();
  if (matrix.size() != 9) throw std::runtime_error(std::string(name) + " must have 9 numbers");
  return {.fx = matrix[0], .fy = matrix[4], .cx = matrix[2], .cy = matrix[5]};
}

// A message; ROS 1 writes K and D.
Calibration ParseCameraInfo(const YAML::Node& yaml) {
  const bool is_ros2 = static_cast<bool>(yaml["k"]);
  Calibration calibration = FromMatrix(Field(yaml, is_ros2 ? "k" : "K"), is_ros2 ? "k" : "K");
  calibration.width = Field(yaml, "width").as<int>();
  calibration.height = Field(yaml, "height").as<int>();
  calibration.distorted = IsDistorted(yaml[is_ros2 ? "d" : "D"]);
  return calibration;
}

Calibration ParseRos(const std::string& text) {
  const YAML::Node yaml = YAML::Load(text);
  if (yaml.IsMap() && (yaml["k"] || yaml["K"])) return ParseCameraInfo(yaml);
  Calibration calibration =
      FromMatrix(Field(Field(yaml, "camera_matrix"), "data"), "camera_matrix");
  calibration.width = Field(yaml, "image_width").as<int>();
  calibration.height = Field(yaml, "image_height").as<int>();
  if (const YAML::Node distortion = yaml["distortion_coefficients"]) {
    calibration.distorted = IsDistorted(Field(distortion, "data"));
  }
  return calibration;
}

Calibration ParseLine(const std::string& text) {
  const std::string line = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  const auto k = ParseNumbers(line, 4, "it", "FX,FY,CX,CY");
  return {.fx = k[0], .fy = k[1], .cx = k[2], .cy = k[3]};
}

void Check(const Calibration& c) {
  const bool finite =
      std::isfinite(c.fx) && std::isfinite(c.fy) && std::isfinite(c.cx) && std::isfinite(c.cy);
  if (!finite || c.fx <= 0 || c.fy <= 0) {
    throw std::runtime_error("focal lengths must be above 0 and all numbers finite");
  }
}

void CheckSize(const Calibration& c) {
  if (c.width <= 0 || c.height <= 0) throw std::runtime_error("width and height must be above 0");
}

Calibration Parse(const std::string& text) {
  const char first = text[std::min(text.find_first_not_of(" \t\r\n"), text.size() - 1)];
  if ((first >= '0' && first <= '9') || first == '.') return ParseLine(text);
  const Calibration calibration = first == '{' ? ParseJson(text) : ParseRos(text);
  CheckSize(calibration);
  return calibration;
}

}  // namespace

Calibration ReadCalibration(const std::string& path) {
  const std::string text = ReadFile(path);
  try {
    const Calibration calibration = Parse(text);
    Check(calibration);
    return calibration;
  } catch (const std::exception& error) {
    throw std::runtime_error("calibration file " + path + ": " + error.what());
  }
}

std::string ToCalibrationJson(const Calibration& c) {
  nlohmann::ordered_json json{{"fx", c.fx}, {"fy", c.fy}, {"cx", c.cx}, {"cy", c.cy}};
  if (c.width > 0) json.update({{"width", c.width}, {"height", c.height}});
  return json.dump(1) + "\n";
}

}  // namespace fovea::cli
