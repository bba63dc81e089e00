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

// Squares of the steps of colour at each place that the outline may move to: kSide colours of its
// inner side less those of its outer.
std::array<int, kWays> SquaredSteps(const OutlineProfiles::Sample* samples) {
  std::array<int, kWays> squares{};
  for (int channel = 0; channel < 3; ++channel) {
    std::array<int, kPlaces> values{};
    for (int k = 0; k < kPlaces; ++k) values[k] = samples[k].color[channel];
    for (int way = 0; way < kWays; ++way) {
      int step = 0;
      for (int k = 1; k <= kSide; ++k)
        step += values[way + kSide - k + 1] - values[way + kSide + k];
      squares[way] += step * step;
    }
  }
  return squares;
}

}  // namespace

OutlineProfiles::OutlineProfiles(const cv::Mat& color_rgb, const cv::Mat& depth_m,
                                 const cv::Mat& labels, int label,
                                 const std::vector<Eigen::Vector2f>& contour,
                                 const std::vector<Eigen::Vector2f>& outwards, float scale)
    : label_(label), count_(contour.size()), samples_(contour.size() * kPlaces) {
  const int last_x = labels.cols - 1, last_y = labels.rows - 1;
  for (std::size_t i = 0; i < count_; ++i) {
    for (int k = 0; k < kPlaces; ++k) {
      const Eigen::Vector2f at =
          contour[i] + outwards[i] * (static_cast<float>(kFirst + k) * scale);
      Sample& sample = samples_[i * kPlaces + static_cast<std::size_t>(k)];
      sample.pixel = {cvRound(at.x()), cvRound(at.y())};
      const int x = std::clamp(sample.pixel.x, 0, last_x),
                y = std::clamp(sample.pixel.y, 0, last_y);
      sample.color = color_rgb.ptr<cv::Vec3b>(y)[x];
      sample.is_in_image = x == sample.pixel.x && y == sample.pixel.y;
      if (!sample.is_in_image) continue;
      sample.label = labels.ptr<std::uint16_t>(y)[x];
      sample.depth_m = depth_m.ptr<float>(y)[x];
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
    const std::array<int, kWays> squares = SquaredSteps(&samples_[i * kPlaces]);
    for (int way = 0; way < kWays; ++way) {
      const float difference = std::sqrt(static_cast<float>(squares[way])) / kSide;
      costs[i * kWays + way] = -std::min(difference / kFullDifference, 1.0F);
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

const OutlineProfiles::Sample* OutlineProfiles::Beyond(std::size_t i, int place) const {
  std::array<const Sample*, kBeyond - kGap + 1> found{};
  std::ptrdiff_t count = 0;
  for (int k = kGap; k <= kBeyond; ++k) {
    const Sample& sample = At(i, place + k);
    if (!IsInside(sample) && !std::isnan(sample.depth_m)) found[count++] = &sample;
  }
  if (count == 0) return nullptr;
  const auto middle = found.begin() + count / 2;
  std::nth_element(found.begin(), middle, found.begin() + count,
                   [](const Sample* a, const Sample* b) { return a->depth_m < b->depth_m; });
  return *middle;
}

float OutlineProfiles::DepthBefore(std::size_t i, int place) const {
  std::array<float, kPlaces> found{};
  std::ptrdiff_t count = 0;
  for (int before = kFirst; before <= std::max(place, 0); ++before) {
    const Sample& sample = At(i, before);
    if (IsInside(sample) && !std::isnan(sample.depth_m)) found[count++] = sample.depth_m;
  }
  if (count == 0) return std::numeric_limits<float>::quiet_NaN();
  const auto middle = found.begin() + count / 2;
  std::nth_element(found.begin(), middle, found.begin() + count);
  return *middle;
}

bool OutlineProfiles::EndsAt(std::size_t i, int place, const Sample* beyond) const {
  for (int k = kGap; k <= kBeyond; ++k) {
    if (!At(i, place + k).is_in_image) return false;
  }
  if (beyond == nullptr) return true;
  const float before_m = DepthBefore(i, place);
  return std::isnan(before_m) ||
         beyond->depth_m > before_m - kNearerPerM * std::max(0.5F, before_m * before_m);
}

}  // namespace fovea
