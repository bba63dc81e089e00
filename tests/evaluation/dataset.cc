#include "tests/evaluation/dataset.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <tuple>

namespace fovea::evaluation {
namespace {

namespace fs = std::filesystem;

fs::path FileOf(const fs::path& folder, const std::string& name, const std::string& what) {
  return folder / (name + "_" + what + ".png");
}

cv::Mat Read(const fs::path& path, int type, const cv::Size& size = {}) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  if (image.empty()) throw std::runtime_error(path.string() + ": cannot be read as an image");
  if (image.type() != type) throw std::runtime_error(path.string() + ": unexpected pixel type");
  if (!size.empty() && image.size() != size) {
    throw std::runtime_error(path.string() + ": its size differs from the colour image's");
  }
  return image;
}

// learn2 before learn10.
std::tuple<std::string, int, std::string> SortKey(const std::string& name) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto first = std::find_if(name.begin(), name.end(), is_digit);
  const auto last = std::find_if_not(first, name.end(), is_digit);
  const std::string digits(first, std::min(last, first + std::min<long>(9, last - first)));
  return {std::string(name.begin(), first), digits.empty() ? -1 : std::stoi(digits), name};
}

cv::Mat DecodeLabels(const cv::Mat& image, LabelEncoding encoding) {
  cv::Mat truth;
  image.convertTo(truth, CV_16U);
  if (encoding == LabelEncoding::kPlain) return truth;
  truth.forEach<std::uint16_t>([](std::uint16_t& label, const int*) {
    label = label >= 20 ? static_cast<std::uint16_t>(label / 10 - 1) : 0;
  });
  return truth;
}

}  // namespace

RgbdFrame LoadFrame(const fs::path& color, const fs::path& depth,
                    const CameraIntrinsics& intrinsics) {
  RgbdFrame frame;
  frame.intrinsics = intrinsics;
  const cv::Mat color_bgr = Read(color, CV_8UC3);
  cv::cvtColor(color_bgr, frame.color_rgb, cv::COLOR_BGR2RGB);
  const cv::Mat depth_mm = Read(depth, CV_16UC1, color_bgr.size());
  depth_mm.convertTo(frame.depth_m, CV_32F, 0.001);
  frame.depth_m.setTo(std::numeric_limits<float>::quiet_NaN(), depth_mm == 0);
  return frame;
}

std::vector<std::string> SceneNames(const fs::path& folder) {
  const std::string ending = "_color.png";
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    if (!name.ends_with(ending)) continue;
    name.resize(name.size() - ending.size());
    if (fs::exists(FileOf(folder, name, "depth")) && fs::exists(FileOf(folder, name, "label"))) {
      names.push_back(name);
    }
  }
  if (names.empty()) throw std::runtime_error(folder.string() + ": no labelled scenes here");
  std::sort(names.begin(), names.end(),
            [](const auto& a, const auto& b) { return SortKey(a) < SortKey(b); });
  return names;
}

Scene LoadScene(const fs::path& folder, const std::string& name, LabelEncoding encoding,
                const CameraIntrinsics& intrinsics) {
  Scene scene;
  scene.name = name;
  scene.frame = LoadFrame(FileOf(folder, name, "color"), FileOf(folder, name, "depth"), intrinsics);
  const cv::Size size = scene.frame.color_rgb.size();
  scene.truth = DecodeLabels(Read(FileOf(folder, name, "label"), CV_8UC1, size), encoding);
  const fs::path labelled = FileOf(folder, name, "labelled_depth");
  const fs::path depth = fs::exists(labelled) ? labelled : FileOf(folder, name, "depth");
  scene.valid = Read(depth, CV_16UC1, size) > 0;
  return scene;
}

}  // namespace fovea::evaluation
