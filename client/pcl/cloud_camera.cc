// Which camera took a cloud.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "client/images.h"
#include "client/pcl/clouds.h"
#include "client/pcl/organized.h"

namespace fovea::client {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

constexpr char kAxes[] = "x right, y down, z forward in the camera frame";

// pixel = focal · slope + center, by least squares.
struct Line {
  double n = 0, slope = 0, pixel = 0, slope2 = 0, both = 0;
  double first = std::numeric_limits<double>::infinity(), last = -first;  // pixels

  void Add(double s, double p) {
    n += 1;
    slope += s;
    pixel += p;
    slope2 += s * s;
    both += s * p;
    first = std::min(first, p);
    last = std::max(last, p);
  }
  double Focal() const { return (n * both - slope * pixel) / (n * slope2 - slope * slope); }
  double Center() const { return (pixel - Focal() * slope) / n; }
};

// Slopes x/z and y/z and the pixel of each point with depth.
template <typename Visit>
void ForEachRay(const Cloud& cloud, const Visit& visit) {
  for (std::uint32_t v = 0; v < cloud.height; ++v) {
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      const pcl::PointXYZRGB& point = cloud.at(u, v);
      if (HasDepth(point)) visit(double{point.x} / point.z, double{point.y} / point.z, u, v);
    }
  }
}

// The largest distance in pixels between a point and where the camera sees it.
double FarthestFrom(const v1::CameraIntrinsics& k, const Cloud& cloud) {
  double farthest = 0;
  ForEachRay(cloud, [&](double x, double y, std::uint32_t u, std::uint32_t v) {
    farthest =
        std::max({farthest, std::abs(k.fx() * x + k.cx() - u), std::abs(k.fy() * y + k.cy() - v)});
  });
  return farthest;
}

}  // namespace

void RequireOrganized(const Cloud& cloud) {
  if (cloud.width > 0 && cloud.height > 1 &&
      cloud.size() == std::size_t{cloud.width} * cloud.height) {
    return;
  }
  throw std::invalid_argument("the cloud of " + std::to_string(cloud.width) + "x" +
                              std::to_string(cloud.height) + " is not organised as an image");
}

bool HasDepth(const pcl::PointXYZRGB& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z) && point.z > 0;
}

v1::CameraIntrinsics IntrinsicsOf(const Cloud& cloud) {
  RequireOrganized(cloud);
  Line across, down;
  ForEachRay(cloud, [&](double x, double y, std::uint32_t u, std::uint32_t v) {
    across.Add(x, u);
    down.Add(y, v);
  });
  if (!(across.first < across.last && down.first < down.last)) {
    throw std::invalid_argument(
        "the cloud has too few points to tell its camera: those that are finite and have z > 0 lie "
        "in fewer than two columns or rows; they must have " +
        std::string(kAxes));
  }
  v1::CameraIntrinsics k =
      MakeIntrinsics(across.Focal(), down.Focal(), across.Center(), down.Center());
  const bool is_finite = std::isfinite(k.fx() + k.fy() + k.cx() + k.cy());
  if (!is_finite || FarthestFrom(k, cloud) > 1) {
    throw std::invalid_argument(
        "no pinhole camera took this cloud: points are more than a pixel away from where it sees "
        "them; they must have " +
        std::string(kAxes));
  }
  if (!(k.fx() > 0 && k.fy() > 0)) {
    throw std::invalid_argument("the cloud is mirrored or turned: its points must have " +
                                std::string(kAxes));
  }
  return k;
}

}  // namespace fovea::client
