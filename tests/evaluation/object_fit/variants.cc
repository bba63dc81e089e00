#include "tests/evaluation/object_fit/variants.h"

#include <opencv2/core.hpp>

namespace fovea::evaluation {
namespace {

cv::Mat Mirrored(const cv::Mat& image) {
  cv::Mat mirrored;
  cv::flip(image, mirrored, 1);
  return mirrored;
}

RgbdFrame VariantOf(const RgbdFrame& frame, const Variant& variant) {
  RgbdFrame result = frame;
  if (!variant.mirrored) return result;
  result.color_rgb = Mirrored(frame.color_rgb);
  result.depth_m = Mirrored(frame.depth_m);
  result.intrinsics.cx_px = frame.color_rgb.cols - 1 - frame.intrinsics.cx_px;
  if (result.gravity) result.gravity->x() *= -1;
  return result;
}

}  // namespace

BoxedFrame VariantOf(const BoxedFrame& frame, const Variant& variant) {
  BoxedFrame result = frame;
  result.frame = VariantOf(frame.frame, variant);
  if (!variant.mirrored) return result;
  for (BoxedObject& object : result.objects) {
    object.box.x = frame.frame.color_rgb.cols - object.box.br().x;
  }
  return result;
}

Scene VariantOf(const Scene& scene, const Variant& variant) {
  Scene result = scene;
  result.frame = VariantOf(scene.frame, variant);
  if (!variant.mirrored) return result;
  result.truth = Mirrored(scene.truth);
  result.valid = Mirrored(scene.valid);
  return result;
}

}  // namespace fovea::evaluation
