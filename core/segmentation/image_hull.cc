#include "core/segmentation/image_hull.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea {
namespace {

constexpr double kDepthMargin = 0.015;  // share of the depth by which noise and fit may err

using Pixels = std::vector<cv::Point>;

// The pixels of a mask that shows a part of the image.
Pixels PixelsOf(const cv::Mat& mask, const cv::Rect& part) {
  Pixels pixels;
  cv::findNonZero(mask, pixels);
  for (cv::Point& pixel : pixels) pixel += part.tl();
  return pixels;
}

// The ends of runs of pixels in one row: no other is a corner of the hull.
Pixels EndsOfRuns(const Pixels& pixels) {
  Pixels ends;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool is_first = i == 0 || pixels[i - 1].y != pixels[i].y;
    const bool is_last = i + 1 == pixels.size() || pixels[i + 1].y != pixels[i].y;
    if (is_first || is_last) ends.push_back(pixels[i]);
  }
  return ends;
}

cv::Mat HullOf(const Pixels& pixels, const cv::Rect& part) {
  cv::Mat mask = cv::Mat::zeros(part.size(), CV_8UC1);
  Pixels hull;
  cv::convexHull(EndsOfRuns(pixels), hull);
  for (cv::Point& corner : hull) corner -= part.tl();
  cv::fillConvexPoly(mask, hull, cv::Scalar(255));
  return mask;
}

// 1/z = x · u + y · v + w, by least squares: exact for a plane.
cv::Matx31d FitInverseDepth(const cv::Mat& points, const Pixels& pixels) {
  double xx = 0, xy = 0, yy = 0, x = 0, y = 0, count = 0;
  cv::Matx31d right = cv::Matx31d::zeros();
  for (const cv::Point& pixel : pixels) {
    const float z = points.at<cv::Vec3f>(pixel)[2];
    if (std::isnan(z)) continue;
    const double u = pixel.x, v = pixel.y;
    xx += u * u, xy += u * v, yy += v * v, x += u, y += v, count += 1;
    right += cv::Matx31d(u, v, 1) * (1.0 / z);
  }
  const cv::Matx33d normal(xx, xy, x, xy, yy, y, x, y, count);
  return normal.solve(right, cv::DECOMP_SVD);
}

}  // namespace

double ShareSeenThrough(const cv::Mat& labels, const cv::Mat& points, int a, int b) {
  const cv::Mat is_a = labels == a, is_b = labels == b;
  const cv::Rect box = cv::boundingRect(is_a) | cv::boundingRect(is_b);
  const Pixels of_a = PixelsOf(is_a(box), box), of_b = PixelsOf(is_b(box), box);
  Pixels both = of_a;
  both.insert(both.end(), of_b.begin(), of_b.end());
  const cv::Matx31d surface = FitInverseDepth(points, both);
  const Pixels gap = PixelsOf(HullOf(both, box) & ~HullOf(of_a, box) & ~HullOf(of_b, box), box);
  std::size_t seen_through = 0;
  for (const cv::Point& pixel : gap) {
    const double expected = surface(0) * pixel.x + surface(1) * pixel.y + surface(2);
    const double seen = 1.0 / points.at<cv::Vec3f>(pixel)[2];
    if (seen < (1 - kDepthMargin) * expected) ++seen_through;  // false for NaN
  }
  return gap.empty() ? 0 : static_cast<double>(seen_through) / static_cast<double>(gap.size());
}

}  // namespace fovea
