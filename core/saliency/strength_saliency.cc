#include "core/saliency/strength_saliency.h"

#include <cmath>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/blocks.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"
#include "core/types/lab.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// The sum of 1 − S over several maps, in their order, whichever is there first. None is kept for
// longer than that takes.
class SumOfContrasts {
 public:
  SumOfContrasts(cv::Size size, std::size_t count)
      : sum_(cv::Mat::zeros(size, CV_32F)), waiting_(count) {}

  void Add(std::size_t index, const cv::Mat& strengths) {
    const std::lock_guard lock(mutex_);
    waiting_[index] = strengths;
    for (; next_ < waiting_.size() && !waiting_[next_].empty(); ++next_) {
      AddContrast(waiting_[next_]);
      waiting_[next_].release();
    }
  }
  cv::Mat Sum() const { return sum_; }

 private:
  void AddContrast(const cv::Mat& strengths) {
    RunInWidestRegisters([&] {
      for (int y = 0; y < sum_.rows; ++y) {
        const float* from = strengths.ptr<float>(y);
        float* to = sum_.ptr<float>(y);
        for (int x = 0; x < sum_.cols; ++x) to[x] += 1.0F - from[x];
      }
    });
  }

  std::mutex mutex_;
  cv::Mat sum_;
  std::size_t next_ = 0;
  std::vector<cv::Mat> waiting_;
};

// Over all scales, of all channels.
cv::Mat ContrastOfAll(const std::vector<cv::Mat>& channels, int num_scales) {
  const std::size_t count = channels.size() * static_cast<std::size_t>(num_scales);
  SumOfContrasts sum(channels.front().size(), count);
  ForEachTogether(count, [&](std::size_t i) {
    InterruptionPoint();
    const int scale = 1 + static_cast<int>(i / channels.size());
    sum.Add(i, PropagateStrength(channels[i % channels.size()], scale));
  });
  return sum.Sum();
}

// In a fixed order, unlike cv::norm: the sum must not depend on the machine's vector width.
void NormalizeL2(cv::Mat& map) {
  InterruptionPoint();
  double sum = 0;
  for (int y = 0; y < map.rows; ++y) {
    const float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) sum += static_cast<double>(row[x]) * row[x];
  }
  if (sum == 0) return;
  const auto norm = static_cast<float>(std::sqrt(sum));
  for (int y = 0; y < map.rows; ++y) {
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] /= norm;
  }
}

}  // namespace

cv::Mat StrengthSaliency(const cv::Mat& color_rgb, const StrengthSaliencyOptions& options) {
  const cv::Mat lab = LabOf(ReduceByBlocks(color_rgb, options.downscale));
  std::vector<cv::Mat> channels;
  cv::split(lab, channels);
  if (options.stretch) {
    for (cv::Mat& channel : channels) cv::normalize(channel, channel, 0, 255, cv::NORM_MINMAX);
  }

  cv::Mat saliency = ContrastOfAll(channels, options.num_scales);
  NormalizeL2(saliency);
  return EnlargeBlocks(saliency, options.downscale, color_rgb.size());
}

}  // namespace fovea
