#include "client/images.h"

#include <stdexcept>
#include <string_view>
#include <utility>

#include "client/rvl.h"

namespace fovea::client {
namespace {

bool IsPng(std::string_view file) { return file.starts_with("\x89PNG\r\n\x1A\n"); }
bool IsJpeg(std::string_view file) { return file.starts_with("\xFF\xD8\xFF"); }

v1::DepthImage MakeRawDepth(const void* pixels, std::size_t pixel_bytes, std::uint32_t width,
                            std::uint32_t height, v1::DepthEncoding encoding) {
  v1::DepthImage image;
  image.set_encoding(encoding);
  image.set_width(width);
  image.set_height(height);
  image.set_data(pixels, std::size_t{width} * height * pixel_bytes);
  return image;
}

}  // namespace

v1::ColorImage MakeColorImage(const void* pixels, std::uint32_t width, std::uint32_t height,
                              v1::ColorEncoding encoding) {
  v1::ColorImage image;
  image.set_encoding(encoding);
  image.set_width(width);
  image.set_height(height);
  image.set_data(pixels, std::size_t{width} * height * 3);
  return image;
}

v1::ColorImage MakeColorImage(std::string file) {
  v1::ColorImage image;
  if (IsPng(file)) {
    image.set_encoding(v1::COLOR_ENCODING_PNG);
  } else if (IsJpeg(file)) {
    image.set_encoding(v1::COLOR_ENCODING_JPEG);
  } else {
    throw std::invalid_argument("the colour image is neither a PNG nor a JPEG file");
  }
  image.set_data(std::move(file));
  return image;
}

v1::DepthImage MakeDepthImage(const std::uint16_t* units, std::uint32_t width, std::uint32_t height,
                              double unit_m) {
  v1::DepthImage image =
      MakeRawDepth(units, sizeof *units, width, height, v1::DEPTH_ENCODING_16UC1);
  image.set_unit_m(unit_m);
  return image;
}

v1::DepthImage MakeRvlDepthImage(const std::uint16_t* units, std::uint32_t width,
                                 std::uint32_t height, double unit_m) {
  v1::DepthImage image;
  image.set_encoding(v1::DEPTH_ENCODING_16UC1_RVL);
  image.set_width(width);
  image.set_height(height);
  image.set_data(EncodeRvl(units, std::size_t{width} * height));
  image.set_unit_m(unit_m);
  return image;
}

v1::DepthImage MakeDepthImage(const float* meters, std::uint32_t width, std::uint32_t height) {
  return MakeRawDepth(meters, sizeof *meters, width, height, v1::DEPTH_ENCODING_32FC1);
}

v1::DepthImage MakeDepthImage(std::string png_file, double unit_m) {
  if (!IsPng(png_file)) throw std::invalid_argument("the depth image is not a PNG file");
  v1::DepthImage image;
  image.set_encoding(v1::DEPTH_ENCODING_16UC1_PNG);
  image.set_data(std::move(png_file));
  image.set_unit_m(unit_m);
  return image;
}

v1::CameraIntrinsics MakeIntrinsics(double fx, double fy, double cx, double cy) {
  v1::CameraIntrinsics intrinsics;
  intrinsics.set_fx(fx);
  intrinsics.set_fy(fy);
  intrinsics.set_cx(cx);
  intrinsics.set_cy(cy);
  return intrinsics;
}

v1::LensDistortion MakeLensDistortion(const std::string& model,
                                      const std::vector<double>& coefficients) {
  v1::LensDistortion distortion;
  if (model == "plumb_bob" || model == "rational_polynomial") {
    distortion.set_model(v1::DISTORTION_MODEL_BROWN_CONRADY);
  } else if (model == "equidistant") {
    distortion.set_model(v1::DISTORTION_MODEL_KANNALA_BRANDT);
  } else if (!model.empty() || !coefficients.empty()) {  // else a camera_info that says nothing
    throw std::invalid_argument("distortion model \"" + model +
                                "\" is not plumb_bob, rational_polynomial or equidistant");
  }
  distortion.mutable_coefficients()->Add(coefficients.begin(), coefficients.end());
  return distortion;
}

v1::Pose MakePose(double x, double y, double z, double qx, double qy, double qz, double qw) {
  v1::Pose pose;
  pose.mutable_position()->set_x(x);
  pose.mutable_position()->set_y(y);
  pose.mutable_position()->set_z(z);
  pose.mutable_orientation()->set_x(qx);
  pose.mutable_orientation()->set_y(qy);
  pose.mutable_orientation()->set_z(qz);
  pose.mutable_orientation()->set_w(qw);
  return pose;
}

}  // namespace fovea::client
