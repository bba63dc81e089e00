#include "core/segmentation/gap.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea {
namespace {

constexpr double kDepthMargin = 0.015;  // share of the depth by which noise and fit may err

using Pixels = std::vector<cv::Point>;

Pixels PixelsOf(const cv::Mat& labels, int label) {
  Pixels pixels;
  cv::findNonZero(labels == label, pixels);
  return pixels;
}

cv::Mat HullOf(const Pixels& pixels, cv::Size size) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  Pixels hull;
  cv::convexHull(pixels, hull);
  cv::fillConvexPoly(mask, hull, cv::Scalar(255));
  return mask;
}

// 1/z = x · u + y · v + w, by least squares: exact for a plane.
cv::Matx31d FitInverseDepth(const cv::Mat& points, const Pixels& pixels) {
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Matx31d right = cv::Matx31d::zeros();
  for (const cv::Point& pixel : pixels) {
    const float z = points.at<cv::Vec3f>(pixel)[2];
    if (std::isnan(z)) continue;
    const cv::Matx31d row(pixel.x, pixel.y, 1);
    normal += row * row.t();
    right += row * (1.0 / z);
  }
  return normal.solve(right, cv::DECOMP_SVD);
}

}  // namespace

double ShareSeenThrough(const cv::Mat& labels, const cv::Mat& points, int a, int b) {
  const Pixels of_a = PixelsOf(labels, a), of_b = PixelsOf(labels, b);
  Pixels both = of_a;
  both.insert(both.end(), of_b.begin(), of_b.end());
  const cv::Matx31d surface = FitInverseDepth(points, both);
  const cv::Mat between =
      HullOf(both, labels.size()) & ~HullOf(of_a, labels.size()) & ~HullOf(of_b, labels.size());
  Pixels gap;
  cv::findNonZero(between, gap);
  std::size_t seen_through = 0;
  for (const cv::Point& pixel : gap) {
    const double expected = surface(0) * pixel.x + surface(1) * pixel.y + surface(2);
    const double seen = 1.0 / points.at<cv::Vec3f>(pixel)[2];
    if (seen < (1 - kDepthMargin) * expected) ++seen_through;  // false for NaN
  }
  return gap.empty() ? 0 : static_cast<double>(seen_through) / static_cast<double>(gap.size());
}

}  // namespace fovea
