#include "core/shape/outline_profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fovea {
namespace {

constexpr int kInside = 7, kOutside = 11;  // places that the outline may move to
constexpr int kSide = 2;                   // colours that are compared on each side
constexpr int kBeyond = 7;                 // that are looked at outside for what ends there
constexpr int kFirst = -kInside - kSide;   // sampled places
constexpr int kLast = kOutside + kBeyond;
constexpr int kGap = 3;  // pixels at an edge are of neither side
constexpr int kPlaces = kLast - kFirst + 1;
constexpr int kWays = kInside + kOutside + 1;

// Costs, where the full difference of colours is worth 1. The outcome changes little between half
// and twice of each.
constexpr float kFullDifference = 90;       // of 8-bit RGB, Euclidean
constexpr float kPerPlaceInside = 0.08F;    // of the mask
constexpr float kPerPlaceMeasured = 0.05F;  // outside of it, with depth of something else
constexpr float kPerPlaceInGap = 0.03F;     // away from the middle of a gap without depth
constexpr float kPerBend = 0.2F;            // per place, from one point to the next

// As cameras of this class have it: noise grows with the square of the distance (Khoshelham and
// Elberink 2012); what is nearer by more than this is something else.
constexpr float kNearerPerM = 0.015F;

}  // namespace

OutlineProfiles::OutlineProfiles(const cv::Mat& color_rgb, const cv::Mat& depth_m,
                                 const cv::Mat& labels, int label,
                                 const std::vector<Eigen::Vector2f>& contour,
                                 const std::vector<Eigen::Vector2f>& outwards, float scale)
    : label_(label), count_(contour.size()), samples_(contour.size() * kPlaces) {
  const cv::Rect image({}, labels.size());
  for (std::size_t i = 0; i < count_; ++i) {
    for (int k = 0; k < kPlaces; ++k) {
      const Eigen::Vector2f at =
          contour[i] + outwards[i] * (static_cast<float>(kFirst + k) * scale);
      Sample& sample = samples_[i * kPlaces + static_cast<std::size_t>(k)];
      sample.pixel = {cvRound(at.x()), cvRound(at.y())};
      sample.is_in_image = image.contains(sample.pixel);
      const cv::Point nearest(std::clamp(sample.pixel.x, 0, image.width - 1),
                              std::clamp(sample.pixel.y, 0, image.height - 1));
      sample.color = color_rgb.at<cv::Vec3b>(nearest);
      if (!sample.is_in_image) continue;
      sample.label = labels.at<std::uint16_t>(sample.pixel);
      sample.depth_m = depth_m.at<float>(sample.pixel);
    }
  }
}

const OutlineProfiles::Sample& OutlineProfiles::At(std::size_t i, int place) const {
  return samples_[i * kPlaces + static_cast<std::size_t>(place - kFirst)];
}

// How many places beyond the mask nothing was measured in.
int OutlineProfiles::GapAt(std::size_t i) const {
  int gap = 0;
  while (gap < kOutside && std::isnan(At(i, gap + 1).depth_m)) ++gap;
  return gap;
}

std::vector<float> OutlineProfiles::Costs() const {
  std::vector<float> costs(count_ * kWays);
  for (std::size_t i = 0; i < count_; ++i) {
    float* const row = &costs[i * kWays] + kInside;
    for (int place = -kInside; place <= kOutside; ++place) {
      cv::Vec3i step;
      for (int k = 1; k <= kSide; ++k) {
        step += cv::Vec3i(At(i, place - k + 1).color) - cv::Vec3i(At(i, place + k).color);
      }
      const float difference = std::sqrt(static_cast<float>(step.dot(step))) / kSide;
      row[place] = -std::min(difference / kFullDifference, 1.0F);
    }
    const int gap = GapAt(i);
    float held = 0;
    for (int place = 1; place <= kOutside; ++place) {
      const Sample& sample = At(i, place);
      if (!IsInside(sample) && !std::isnan(sample.depth_m)) held += kPerPlaceMeasured;
      if (place <= gap) held += 2 * place <= gap ? -kPerPlaceInGap : kPerPlaceInGap;
      row[place] += held;
    }
    for (int place = -1; place >= -kInside; --place) {
      row[place] += kPerPlaceInside * static_cast<float>(-place);
    }
  }
  return costs;
}

std::vector<int> OutlineProfiles::BestWayAround() const {
  if (count_ == 0) return {};
  const std::vector<float> costs = Costs();
  // Twice around, and the second half of the first and the first half of the second round taken:
  // where the way begins then matters no more.
  const std::size_t steps = 2 * count_;
  std::vector<std::array<std::int8_t, kWays>> from(steps);
  std::array<float, kWays> sums{};
  for (std::size_t step = 0; step < steps; ++step) {
    std::array<float, kWays> best = sums;
    std::array<std::int8_t, kWays>& came = from[step];
    for (int k = 0; k < kWays; ++k) came[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(k);
    for (std::size_t k = 1; k < kWays; ++k) {
      if (best[k - 1] + kPerBend >= best[k]) continue;
      best[k] = best[k - 1] + kPerBend;
      came[k] = came[k - 1];
    }
    for (std::size_t k = kWays - 1; k-- > 0;) {
      if (best[k + 1] + kPerBend >= best[k]) continue;
      best[k] = best[k + 1] + kPerBend;
      came[k] = came[k + 1];
    }
    const float* const row = &costs[(step % count_) * kWays];
    for (std::size_t k = 0; k < kWays; ++k) sums[k] = best[k] + row[k];
  }
  std::vector<int> way(steps);
  auto k = static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
  for (std::size_t step = steps; step-- > 0;) {
    way[step] = static_cast<int>(k) - kInside;
    k = static_cast<std::size_t>(from[step][k]);
  }
  std::vector<int> around(count_);
  for (std::size_t i = 0; i < count_; ++i) around[i] = way[i < count_ / 2 ? count_ + i : i];
  return around;
}

const OutlineProfiles::Sample* OutlineProfiles::MedianOf(std::size_t i, int first, int last,
                                                         bool of_object) const {
  std::array<const Sample*, kPlaces> found{};
  std::size_t count = 0;
  for (int place = first; place <= last; ++place) {
    const Sample& sample = At(i, place);
    if (IsInside(sample) == of_object && !std::isnan(sample.depth_m)) found[count++] = &sample;
  }
  if (count == 0) return nullptr;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(found.begin(), middle, found.begin() + static_cast<std::ptrdiff_t>(count),
                   [](const Sample* a, const Sample* b) { return a->depth_m < b->depth_m; });
  return *middle;
}

const OutlineProfiles::Sample* OutlineProfiles::Beyond(std::size_t i, int place) const {
  return MedianOf(i, place + kGap, place + kBeyond, false);
}

bool OutlineProfiles::EndsAt(std::size_t i, int place) const {
  for (int k = kGap; k <= kBeyond; ++k) {
    if (!At(i, place + k).is_in_image) return false;
  }
  const Sample* before = MedianOf(i, kFirst, std::max(place, 0), true);
  const Sample* beyond = Beyond(i, place);
  if (before == nullptr || beyond == nullptr) return true;
  const float before_m = before->depth_m;
  return beyond->depth_m > before_m - kNearerPerM * std::max(0.5F, before_m * before_m);
}

}  // namespace fovea
