// The images of a request, and where the cameras are, from what a camera driver hands out. All
// copy; rows have no padding.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fovea/v1/frame.pb.h"

namespace fovea::client {

// width * height * 3 bytes; `encoding` is COLOR_ENCODING_RGB8 or COLOR_ENCODING_BGR8.
v1::ColorImage MakeColorImage(const void* pixels, std::uint32_t width, std::uint32_t height,
                              v1::ColorEncoding encoding);

// A whole PNG or JPEG file, sent as it is. Throws std::invalid_argument for other bytes.
v1::ColorImage MakeColorImage(std::string file);

// width * height values in units of `unit_m` metres, 0 = not measured.
v1::DepthImage MakeDepthImage(const std::uint16_t* units, std::uint32_t width, std::uint32_t height,
                              double unit_m = 0.001);

// The same without loss in a sixth of the bytes, for less than a millisecond on either side.
v1::DepthImage MakeRvlDepthImage(const std::uint16_t* units, std::uint32_t width,
                                 std::uint32_t height, double unit_m = 0.001);

// width * height values in metres, NaN or <= 0 = not measured.
v1::DepthImage MakeDepthImage(const float* meters, std::uint32_t width, std::uint32_t height);

// A whole 16-bit PNG file, sent as it is. Throws std::invalid_argument for other bytes.
v1::DepthImage MakeDepthImage(std::string png_file, double unit_m = 0.001);

v1::CameraIntrinsics MakeIntrinsics(double fx, double fy, double cx, double cy);

// For CameraIntrinsics.distortion, by the names and numbers of ROS's camera_info, in OpenCV's
// order: "plumb_bob" (k1, k2, p1, p2, k3), "rational_polynomial" (and k4, k5, k6) or "equidistant"
// (k1 to k4 of a fisheye). Without coefficients nothing is distorted, and the name may be empty.
// Throws std::invalid_argument for another name; the server checks the rest.
v1::LensDistortion MakeLensDistortion(const std::string& model,
                                      const std::vector<double>& coefficients);

// Metres and a unit quaternion, for example for Frame.color_from_depth.
v1::Pose MakePose(double x, double y, double z, double qx, double qy, double qz, double qw);

}  // namespace fovea::client
