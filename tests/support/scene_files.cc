#include "tests/support/scene_files.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace fovea::scenes {
namespace {

using nlohmann::json;

cv::Mat InMillimetres(const cv::Mat& depth_m) {
  cv::Mat known = depth_m.clone(), depth_mm;
  cv::patchNaNs(known, 0);
  known.convertTo(depth_mm, CV_16U, 1000);
  return depth_mm;
}

template <typename Vector>
json ToJson(const Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

json ToJson(const CameraIntrinsics& k) {
  return {{"fx_px", k.fx_px}, {"fy_px", k.fy_px}, {"cx_px", k.cx_px}, {"cy_px", k.cy_px}};
}

json ToJson(const SupportSurface& surface) {
  return {{"normal", ToJson(surface.normal)}, {"offset_m", surface.offset_m}};
}

json ToJson(const ObjectTruth& object) {
  const Eigen::Quaterniond rotation(object.camera_from_object.linear());
  return {{"label", object.label},
          {"name", object.name},
          {"size_m", ToJson(object.shape.size_m)},
          {"center_m", ToJson(object.camera_from_object.translation().eval())},
          {"rotation_xyzw", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}},
          {"num_pixels", object.num_pixels}};
}

template <typename Item>
json ListToJson(const std::vector<Item>& items) {
  json list = json::array();
  for (const Item& item : items) list.push_back(ToJson(item));
  return list;
}

}  // namespace

void WriteImage(const std::filesystem::path& path, const cv::Mat& image) {
  if (!cv::imwrite(path.string(), image)) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

void WriteFrame(const std::filesystem::path& folder, const std::string& name,
                const LabelledFrame& labelled) {
  cv::Mat color_bgr, labels;
  cv::cvtColor(labelled.frame.color_rgb, color_bgr, cv::COLOR_RGB2BGR);
  labelled.labels.convertTo(labels, CV_8U);
  WriteImage(folder / (name + "_color.png"), color_bgr);
  WriteImage(folder / (name + "_depth.png"), InMillimetres(labelled.frame.depth_m));
  WriteImage(folder / (name + "_label.png"), labels);

  const json truth = {{"intrinsics", ToJson(labelled.frame.intrinsics)},
                      {"gravity", ToJson(labelled.gravity)},
                      {"supports", ListToJson(labelled.supports)},
                      {"objects", ListToJson(labelled.objects)}};
  const std::filesystem::path path = folder / (name + ".json");
  std::ofstream file(path);
  file << truth.dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace fovea::scenes
