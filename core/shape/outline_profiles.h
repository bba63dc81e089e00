// Across the outline of a mask: colours and depth on both sides of each of its points.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

namespace fovea {

class OutlineProfiles {
 public:
  // `depth_m`: CV_32FC1, NaN = none; `contour` and its unit normals in pixels; places across it are
  // `scale` px apart.
  OutlineProfiles(const cv::Mat& color_rgb, const cv::Mat& depth_m, const cv::Mat& labels,
                  int label, const std::vector<Eigen::Vector2f>& contour,
                  const std::vector<Eigen::Vector2f>& outwards, float scale);

  // For each point of the contour the place across it (0 = on it, positive = outside) of the way
  // around that costs least: little where the colours differ, more the more it bends.
  std::vector<int> BestWayAround() const;

  struct Sample {
    cv::Vec3b color;  // of the nearest pixel of the image
    bool is_in_image = false;
    float depth_m = std::numeric_limits<float>::quiet_NaN();
    int label = 0;
    cv::Point pixel;
  };

  // What lies beyond this place of point `i`: the one of median depth; null where nothing was
  // measured.
  const Sample* Beyond(std::size_t i, int place) const;

  // Whether that is farther away than what lies before the place.
  bool EndsAt(std::size_t i, int place, const Sample* beyond) const;

 private:
  const Sample& At(std::size_t i, int place) const;
  int GapAt(std::size_t i) const;
  std::vector<float> Costs() const;
  bool IsInside(const Sample& sample) const { return sample.label == label_; }
  float DepthBefore(std::size_t i, int place) const;  // median of the object; NaN = none

  int label_ = 0;
  std::size_t count_ = 0;
  std::vector<Sample> samples_;  // of point i: kPlaces in a row
};

}  // namespace fovea
