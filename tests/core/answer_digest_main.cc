// Prints a digest of the answer to each of some frames, or one of the C library's functions.
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <opencv2/core.hpp>
#include <random>
#include <string>
#include <type_traits>

#include "core/detector.h"
#include "tests/core/frame_file.h"

namespace fovea {
namespace {

// FNV-1a of the bytes of what is added.
class Digest {
 public:
  template <typename Number>
  void Add(const Number& number) {
    static_assert(std::is_arithmetic_v<Number>);
    AddBytes(&number, sizeof number);
  }
  template <typename Number, int Rows, int Cols>
  void Add(const Eigen::Matrix<Number, Rows, Cols>& matrix) {
    AddBytes(matrix.data(), sizeof(Number) * matrix.size());
  }
  void Add(const cv::Mat& image) {
    for (int row = 0; row < image.rows; ++row)
      AddBytes(image.ptr(row), image.cols * image.elemSize());
  }
  void Add(const std::string& text) { AddBytes(text.data(), text.size()); }

  std::uint64_t value() const { return value_; }

 private:
  void AddBytes(const void* bytes, std::size_t size) {
    for (const char* byte = static_cast<const char*>(bytes); size > 0; ++byte, --size) {
      value_ = (value_ ^ static_cast<unsigned char>(*byte)) * 1'099'511'628'211U;
    }
  }

  std::uint64_t value_ = 14'695'981'039'346'656'037U;
};

void Add(const DetectedObject& object, Digest& digest) {
  digest.Add(object.confidence);
  digest.Add(object.saliency);
  digest.Add(object.box.center);
  digest.Add(object.box.rotation);
  digest.Add(object.box.size_m);
  digest.Add(object.centroid);
  for (const std::uint8_t channel : object.mean_color) digest.Add(channel);
  digest.Add(object.height_above_support_m.value_or(-1));
  digest.Add(object.truncated);
  for (const Grasp& grasp : object.grasps) {
    digest.Add(grasp.tool_center_point);
    digest.Add(grasp.approach);
    digest.Add(grasp.closing);
    digest.Add(grasp.opening_m);
    digest.Add(grasp.pre_grasp_opening_m);
  }
}

std::uint64_t DigestOf(const Detections& found) {
  Digest digest;
  digest.Add(found.labels);
  for (const DetectedObject& object : found.objects) Add(object, digest);
  for (const RejectedObject& rejected : found.rejected) {
    digest.Add(rejected.probability);
    digest.Add(rejected.reason);
  }
  digest.Add(found.gravity.direction);
  if (found.support) {
    digest.Add(found.support->normal);
    digest.Add(found.support->offset_m);
  }
  digest.Add(found.diagnostics.num_seeds);
  digest.Add(found.diagnostics.num_voxels);
  digest.Add(found.diagnostics.num_segments);
  for (const std::string& message : found.diagnostics.messages) digest.Add(message);
  return digest.value();
}

std::uint64_t DigestOfLibrary() {
  std::mt19937_64 random(1);
  Digest digest;
  for (int i = 0; i < 100'000; ++i) {
    const double x = static_cast<double>(random() % 1'000'000 + 1) * 1e-6;
    digest.Add(std::exp(-x));
    digest.Add(std::log(x));
  }
  return digest.value();
}

void PrintAnswers(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  for (RgbdFrame frame; ReadFrame(file, frame);) {
    for (const std::string& profile : ProfileNames()) {
      const Detections found = Detect(frame, OptionsOfProfile(profile));
      std::cout << profile << ' ' << found.objects.size() << " objects " << DigestOf(found) << '\n';
    }
  }
}

}  // namespace
}  // namespace fovea

// usage: fovea-answer-digest FRAMES [INSTRUCTION_SET], which the test has written and Highway's
// number of it, or nothing for the library.
int main(int argc, char** argv) {
  if (argc > 2) hwy::SetSupportedTargetsForTest(std::stoll(argv[2]));
  if (argc > 1) {
    fovea::PrintAnswers(argv[1]);
  } else {
    std::cout << fovea::DigestOfLibrary() << '\n';
  }
}
