#include "client/capture/calibration_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "client/cli/files.h"

namespace fovea::capture {
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

Calibration ParseRos(const std::string& text) {
  const YAML::Node yaml = YAML::Load(text);
  const auto matrix = Field(Field(yaml, "camera_matrix"), "data").as<std::vector<double>>();
  if (matrix.size() != 9) throw std::runtime_error("camera_matrix must have 9 numbers");
  Calibration calibration{.fx = matrix[0],
                          .fy = matrix[4],
                          .cx = matrix[2],
                          .cy = matrix[5],
                          .width = Field(yaml, "image_width").as<int>(),
                          .height = Field(yaml, "image_height").as<int>()};
  if (const YAML::Node distortion = yaml["distortion_coefficients"]) {
    const auto values = Field(distortion, "data").as<std::vector<double>>();
    calibration.distorted =
        std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
  }
  return calibration;
}

void Check(const Calibration& c) {
  const bool finite =
      std::isfinite(c.fx) && std::isfinite(c.fy) && std::isfinite(c.cx) && std::isfinite(c.cy);
  if (!finite || c.fx <= 0 || c.fy <= 0) {
    throw std::runtime_error("focal lengths must be above 0 and all numbers finite");
  }
  if (c.width <= 0 || c.height <= 0) throw std::runtime_error("width and height must be above 0");
}

}  // namespace

Calibration ReadCalibration(const std::string& path) {
  const std::string text = cli::ReadFile(path);
  try {
    const bool is_json = text[std::min(text.find_first_not_of(" \t\r\n"), text.size() - 1)] == '{';
    const Calibration calibration = is_json ? ParseJson(text) : ParseRos(text);
    Check(calibration);
    return calibration;
  } catch (const std::exception& error) {
    throw std::runtime_error("calibration file " + path + ": " + error.what());
  }
}

}  // namespace fovea::capture
