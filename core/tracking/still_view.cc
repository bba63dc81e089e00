#include "core/tracking/still_view.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace fovea {
namespace {

constexpr int kWidth_px = 160;
constexpr int kMinHeight_px = 3, kMaxHeight_px = 4 * kWidth_px;  // of images like ribbons
constexpr double kMaxShift_px = 0.33 / 640 * kWidth_px;
constexpr double kChange = 25;                         // grey levels: beyond noise and small shifts
constexpr double kMaxChanged = 0.1;                    // of the pixels: a hand or a passer-by
constexpr double kFewestOfPixels = 0.2;                // that lie outside of objects
constexpr double kMaxDeviation_px = kMaxShift_px / 3;  // of what is measured
// A hand that nobody detected may be like what it hides, and pulls at the motion: what is farther
// off than that from the motion that was found is left out, and another one found without it.
constexpr double kSigmas = 3;
constexpr int kRounds = 3;
// Of the differences that no shift explains, in squares of grey levels: what noise leaves, and what
// it is beside the gradients. Fine texture that has moved by more than a pixel is like other
// texture: as far as any shift explains it there was none, and what is left is above the gradients'
// squares.
constexpr double kNoise = 4, kMaxOfGradients = 0.25;

using Row = Eigen::Matrix<double, 6, 1>;

// Grey values of `a` change by row · (shift x, shift y, scale, turn, exposure, offset) to `b`.
struct Equations {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Row right = Row::Zero();
  double squares = 0;
  int used = 0, changed = 0;

  void Add(const Row& row, double difference) {
    matrix += row * row.transpose();
    right += row * difference;
    squares += difference * difference;
    ++used;
  }
};

// Of what is within so many grey levels of that motion; the rest has changed.
Equations Compare(const SmallView& a, const SmallView& b, const Row& motion, double within) {
  Equations equations;
  const double radius = a.gray.cols / 2.0;
  for (int y = 1; y + 1 < a.gray.rows; ++y) {
    for (int x = 1; x + 1 < a.gray.cols; ++x) {
      if (a.movable.at<std::uint8_t>(y, x) != 0 || b.movable.at<std::uint8_t>(y, x) != 0) continue;
      const float value = a.gray.at<float>(y, x), difference = b.gray.at<float>(y, x) - value;
      const double gx = (a.gray.at<float>(y, x + 1) - a.gray.at<float>(y, x - 1)) / 2;
      const double gy = (a.gray.at<float>(y + 1, x) - a.gray.at<float>(y - 1, x)) / 2;
      const double u = x / radius - 1, v = (y - a.gray.rows / 2.0) / radius;
      const Row row =
          (Row() << gx, gy, gx * u + gy * v, gy * u - gx * v, value / 128, 1).finished();
      if (std::abs(difference - row.dot(motion)) > within) {
        ++equations.changed;
      } else {
        equations.Add(row, difference);
      }
    }
  }
  return equations;
}

struct Solution {
  Row motion, deviation;
  double variance;  // of what the motion does not explain
};

// None where too little is the same, or has contrast.
std::optional<Solution> Solve(const Equations& equations, double pixels) {
  if (equations.used < kFewestOfPixels * pixels) return std::nullopt;
  if (equations.changed > kMaxChanged * (equations.used + equations.changed)) return std::nullopt;
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(equations.matrix);
  const bool has_contrast = equations.matrix.diagonal().head<4>().minCoeff() > 1;
  if (!has_contrast || solver.info() != Eigen::Success || !(solver.rcond() > 1e-12)) {
    return std::nullopt;
  }
  const Row motion = solver.solve(equations.right);
  const double variance =
      std::max(1.0, (equations.squares - motion.dot(equations.right)) / equations.used);
  const Row deviation =
      (variance * solver.solve(Eigen::Matrix<double, 6, 6>::Identity()).diagonal())
          .cwiseMax(0)
          .cwiseSqrt();
  return Solution{motion, deviation, variance};
}

}  // namespace

SmallView SmallViewOf(const RgbdFrame& frame, const cv::Mat& labels) {
  const int height = cvRound(double(kWidth_px) * labels.rows / labels.cols);
  const cv::Size size(kWidth_px, std::clamp(height, kMinHeight_px, kMaxHeight_px));
  SmallView view;
  cv::Mat small, movable;
  cv::resize(frame.color_rgb, small, size, 0, 0, cv::INTER_AREA);
  cv::cvtColor(small, small, cv::COLOR_RGB2GRAY);
  small.convertTo(small, CV_32FC1);
  cv::GaussianBlur(small, view.gray, {3, 3}, 0);
  cv::resize(labels > 0, movable, size, 0, 0, cv::INTER_AREA);
  cv::dilate(movable > 0, view.movable, cv::Mat::ones(5, 5, CV_8UC1));
  return view;
}

bool IsSameView(const SmallView& a, const SmallView& b) {
  if (a.gray.size() != b.gray.size()) return false;
  const auto pixels = static_cast<double>(a.gray.total());
  Equations equations = Compare(a, b, Row::Zero(), kChange);
  std::optional<Solution> solution = Solve(equations, pixels);
  for (int round = 1; solution && round < kRounds; ++round) {
    const double within = std::min(kChange, kSigmas * std::sqrt(solution->variance));
    equations = Compare(a, b, solution->motion, within);
    solution = Solve(equations, pixels);
  }
  if (!solution) return false;
  const double gradients = equations.matrix.diagonal().head<2>().sum() / equations.used;
  if (solution->variance > std::max(kNoise, kMaxOfGradients * gradients)) return false;
  // At the image's edge, where scale and turn shift most.
  const Row& motion = solution->motion;
  const double shift = motion.head<2>().norm() + motion.segment<2>(2).norm();
  const bool can_tell = solution->deviation.head<4>().maxCoeff() < kMaxDeviation_px;
  return can_tell && shift < kMaxShift_px;
}

}  // namespace fovea
