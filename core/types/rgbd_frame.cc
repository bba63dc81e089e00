#include "core/types/rgbd_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fovea {
namespace {

void Require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

// Nearly always it holds, and nobody needs a message.
template <typename... Parts>
void Require(bool holds, fmt::format_string<const Parts&...> format, const Parts&... parts) {
  if (!holds) throw std::invalid_argument(fmt::format(format, parts...));
}

// Along one axis of the image; `names` are those of the focal length and the principal point.
void RequirePlausible(double focal_px, double principal_px, int size_px,
                      const std::array<const char*, 2>& names) {
  constexpr double kMaxSlope = 10, kMaxFocal_px = 1e6;
  Require(std::isfinite(focal_px) && focal_px > 0, "{}: {:g} is not a positive number", names[0],
          focal_px);
  Require(focal_px <= kMaxFocal_px, "{}: {:g} is more than {:g} px", names[0], focal_px,
          kMaxFocal_px);
  Require(std::isfinite(principal_px), "{}: is not a finite number", names[1]);
  const double farthest_px = std::max(std::abs(principal_px), std::abs(size_px - 1 - principal_px));
  if (farthest_px <= kMaxSlope * focal_px) return;
  // Within the image, where most are, it is right with any focal length that is.
  const bool is_outside = principal_px < 0 || principal_px > size_px - 1;
  const bool blames_principal = is_outside && size_px - 1 <= kMaxSlope * focal_px;
  const std::size_t wrong = blames_principal ? 1 : 0;
  const std::array values{focal_px, principal_px};
  Require(false,
          "{}: {:g} px with {} {:g} px sees pixels of an image of {} px more than 84 "
          "degrees beside the optical axis; intrinsics are in pixels of this image",
          names[wrong], values[wrong], names[1 - wrong], values[1 - wrong], size_px);
}

}  // namespace

void RequirePlausible(const CameraIntrinsics& intrinsics, const cv::Size& size) {
  RequirePlausible(intrinsics.fx_px, intrinsics.cx_px, size.width, {"fx", "cx"});
  RequirePlausible(intrinsics.fy_px, intrinsics.cy_px, size.height, {"fy", "cy"});
}

void Validate(const RgbdFrame& frame) {
  Require(!frame.color_rgb.empty(), "color: the image is empty");
  Require(frame.color_rgb.type() == CV_8UC3, "color: must have three 8-bit channels");
  Require(!frame.depth_m.empty(), "depth: the image is empty");
  Require(frame.depth_m.type() == CV_32FC1, "depth: must have one 32-bit float channel");
  Require(frame.color_rgb.size() == frame.depth_m.size(),
          "depth: its size {}x{} differs from colour's {}x{}; depth must be registered to colour",
          frame.depth_m.cols, frame.depth_m.rows, frame.color_rgb.cols, frame.color_rgb.rows);

  Require(frame.unseen.empty() ||
              (frame.unseen.type() == CV_8UC1 && frame.unseen.size() == frame.color_rgb.size()),
          "unseen: must have one 8-bit channel and the size of colour");

  try {
    RequirePlausible(frame.intrinsics, frame.color_rgb.size());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("intrinsics." + std::string(error.what()));
  }
  if (frame.gravity) {
    const float length = frame.gravity->norm();
    Require(std::isfinite(length) && std::abs(length - 1.0F) <= 0.1F,
            "gravity: its length must be 1, is {:f}", length);
  }
}

}  // namespace fovea
