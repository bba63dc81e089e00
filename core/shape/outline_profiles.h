// Across the outline of a mask: colours and depth on both sides of each of its points.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace fovea {

class OutlineProfiles {
 public:
  // `contour` and its unit normals in pixels; places across it are `scale` px apart.
  OutlineProfiles(const cv::Mat& color_rgb, const cv::Mat& points, const cv::Mat& labels, int label,
                  const std::vector<Eigen::Vector2f>& contour,
                  const std::vector<Eigen::Vector2f>& outwards, float scale);

  // For each point of the contour the place across it (0 = on it, positive = outside) of the way
  // around that costs least: little where the colours differ, more the more it bends.
  std::vector<int> BestWayAround() const;

  // Whether what lies beyond this place of point `i` is farther away than what lies before it.
  bool EndsAt(std::size_t i, int place) const;

 private:
  struct Sample {
    Eigen::Vector3f color;
    float z = 0;  // NaN = not measured
    bool is_inside = false, is_in_image = false;
  };

  const Sample& At(std::size_t i, int place) const;
  std::vector<float> Costs() const;
  float MedianZ(std::size_t i, int first, int last, bool of_object) const;

  std::size_t count_ = 0;
  std::vector<Sample> samples_;  // of point i: kPlaces in a row
};

}  // namespace fovea
