#include "client/cli/bag/camera_info.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/bag/cdr_reader.h"
#include "client/cli/bag/message_header.h"
#include "client/cli/camera_window.h"
#include "client/cli/distortion.h"

namespace fovea::cli {
namespace {

CameraWindow ReadWindow(CdrReader& reader) {
  CameraWindow window;
  window.binning_x = reader.Number<std::uint32_t>();
  window.binning_y = reader.Number<std::uint32_t>();
  window.x_offset = reader.Number<std::uint32_t>();
  window.y_offset = reader.Number<std::uint32_t>();
  window.height = reader.Number<std::uint32_t>();
  window.width = reader.Number<std::uint32_t>();
  return window;
}

}  // namespace

Calibration CameraInfo(std::string_view message, bool rectified) {
  CdrReader reader(message);
  ReadHeader(reader);
  const auto height = reader.Number<std::uint32_t>(), width = reader.Number<std::uint32_t>();
  const std::string model(reader.Text());
  std::vector<double> coefficients;
  constexpr std::uint32_t kMostCoefficients = 64;
  const auto count = reader.Number<std::uint32_t>();
  if (count > kMostCoefficients) throw std::invalid_argument("camera_info has too long a d");
  for (std::uint32_t i = 0; i < count; ++i) coefficients.push_back(reader.Number<double>());
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  for (double& value : k) value = reader.Number<double>();
  for (double& value : r) value = reader.Number<double>();
  for (double& value : p) value = reader.Number<double>();
  Calibration calibration{.fx = rectified ? p[0] : k[0],
                          .fy = rectified ? p[5] : k[4],
                          .cx = rectified ? p[2] : k[2],
                          .cy = rectified ? p[6] : k[5],
                          .width = static_cast<int>(width),
                          .height = static_cast<int>(height),
                          .distortion = {}};
  constexpr std::uint32_t kLargest = 1 << 15;
  if (!IsCamera(calibration) || width > kLargest || height > kLargest) {
    throw std::invalid_argument(std::string("it is of no camera (") + (rectified ? "P" : "K") +
                                ", width and height)");
  }
  Apply(ReadWindow(reader), &calibration);
  if (!rectified) calibration.distortion = MakeDistortion(model, coefficients);
  return calibration;
}

}  // namespace fovea::cli
