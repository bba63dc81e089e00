// A z-buffer: draws triangles, of which the nearest is seen.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// A point in the image: pixels, and 1/z in 1/m, which is linear on the image of a plane.
struct ImagePoint {
  double u = 0;
  double v = 0;
  double inverse_z = 0;  // > 0; 0 = cannot be seen
};

class NearestSurface {
 public:
  // Drawing may take `max_steps`; each pixel of a triangle is one, and each of its rows.
  NearestSurface(const cv::Size& size, double max_steps);

  // The pixels whose centres lie in the triangle, its sides included. Leaves out a triangle with a
  // point that cannot be seen or is not finite, and one without area. Throws std::invalid_argument
  // when all triangles together take more than `max_steps`.
  void Draw(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c);

  // z of every pixel: CV_32FC1, NaN = nothing was drawn.
  cv::Mat Depth() const;

 private:
  cv::Mat inverse_z_;  // CV_32FC1, 0 = nothing
  double steps_left_;
};

}  // namespace fovea
