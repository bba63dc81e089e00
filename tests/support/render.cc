#include "tests/support/render.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/core/utility.hpp>

#include "tests/support/value_noise.h"

namespace fovea::scenes {
namespace {

constexpr double kSurfaceOffset_m = 2e-4;  // starts secondary rays outside the surface they leave
constexpr double kAmbientReach_m = 0.25;   // surfaces farther away do not darken one another
constexpr double kLightRadius = 0.07;      // tangent of the light's angular radius
constexpr int kShadowRays = 5;
constexpr int kAmbientRays = 8;

struct Surface {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;
  std::uint32_t x, y;  // pixel, from which the random directions come
};

// A unit vector at right angles to `axis`, and another at right angles to both.
std::pair<Eigen::Vector3d, Eigen::Vector3d> Perpendicular(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

// A point of the unit disk: the i-th of n that spread evenly over it, turned by `turn` (0 … 1).
Eigen::Vector2d SpiralPoint(int i, int n, double turn) {
  const double radius = std::sqrt((i + 0.5) / n);
  const double angle = 2 * std::numbers::pi * (i * std::numbers::phi + turn);
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

// The share of the light's disk that the surface sees.
double LightSeen(const RayCaster& caster, const Surface& surface, const Eigen::Vector3d& towards) {
  const auto [u, v] = Perpendicular(towards);
  const double turn = HashToUnit(surface.x, surface.y, 0, 1);
  int seen = 0;
  for (int i = 0; i < kShadowRays; ++i) {
    const Eigen::Vector2d disk = kLightRadius * SpiralPoint(i, kShadowRays, turn);
    const Eigen::Vector3d direction = towards + disk.x() * u + disk.y() * v;
    seen += !caster.Blocked({surface.point, direction}, std::numeric_limits<double>::infinity());
  }
  return double(seen) / kShadowRays;
}

// The share of the surroundings, weighted by the cosine, in which nothing is near.
double Openness(const RayCaster& caster, const Surface& surface) {
  const auto [u, v] = Perpendicular(surface.normal);
  const double turn = HashToUnit(surface.x, surface.y, 0, 2);
  int open = 0;
  for (int i = 0; i < kAmbientRays; ++i) {
    const Eigen::Vector2d disk = SpiralPoint(i, kAmbientRays, turn);
    const Eigen::Vector3d direction =
        disk.x() * u + disk.y() * v + std::sqrt(1 - disk.squaredNorm()) * surface.normal;
    open += !caster.Blocked({surface.point, direction}, kAmbientReach_m);
  }
  return double(open) / kAmbientRays;
}

// Lambert's law for one distant light and light from all around, a little more of it from above.
double Brightness(const RayCaster& caster, const Surface& surface, const Light& light) {
  const double facing = surface.normal.dot(light.towards);
  const double direct = facing > 0 ? facing * LightSeen(caster, surface, light.towards) : 0;
  const double from_above = 0.8 + 0.2 * surface.normal.z();
  return light.strength * direct + light.ambient * from_above * Openness(caster, surface);
}

// The ray through a pixel's centre; t along it is depth.
Ray PixelRay(const Camera& camera, int x, int y) {
  const CameraIntrinsics& k = camera.intrinsics;
  const Eigen::Vector3d in_camera((x - k.cx_px) / k.fx_px, (y - k.cy_px) / k.fy_px, 1);
  return {camera.world_from_camera.translation(), camera.world_from_camera.linear() * in_camera};
}

std::vector<std::uint16_t> LabelOfEachBody(const Scene& scene) {
  std::vector<std::uint16_t> labels;
  std::uint16_t next = 1;
  for (const Body& body : scene.bodies) labels.push_back(body.is_object ? next++ : 0);
  return labels;
}

Rendering Blank(const cv::Size& size) {
  Rendering rendering;
  rendering.color = cv::Mat(size, CV_32FC3, cv::Scalar(0.75, 0.8, 0.9));
  rendering.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(std::nan("")));
  rendering.labels = cv::Mat::zeros(size, CV_16UC1);
  rendering.cosine = cv::Mat::zeros(size, CV_32FC1);
  rendering.in_second_view = cv::Mat::zeros(size, CV_8UC1);
  return rendering;
}

template <typename Function>
void ForEachHit(const Scene& scene, const Function& function) {
  const RayCaster caster(scene);
  for (int y = 0; y < scene.camera.size_px.height; ++y) {
    for (int x = 0; x < scene.camera.size_px.width; ++x) {
      const auto found = caster.Nearest(PixelRay(scene.camera, x, y));
      if (found) function(x, y, *found);
    }
  }
}

}  // namespace

Rendering Render(const Scene& scene, double baseline_m) {
  const RayCaster caster(scene);
  const std::vector<std::uint16_t> labels = LabelOfEachBody(scene);
  const Eigen::Vector3d second_eye =
      scene.camera.world_from_camera * Eigen::Vector3d(baseline_m, 0, 0);
  Rendering rendering = Blank(scene.camera.size_px);

  const auto render_pixel = [&](int x, int y) {
    const Ray ray = PixelRay(scene.camera, x, y);
    const auto found = caster.Nearest(ray);
    if (!found) return;
    const Body& body = scene.bodies[found->body];
    const Eigen::Vector3d point = ray.At(found->hit.t), normal = found->hit.normal;
    const Surface surface = {point + kSurfaceOffset_m * normal, normal,
                             static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
    const Eigen::Vector3d color =
        Brightness(caster, surface, scene.light) *
        AlbedoAt(MaterialAt(body, found->hit), body.world_from_body.inverse() * point);
    rendering.color.at<cv::Vec3f>(y, x) = {float(color.x()), float(color.y()), float(color.z())};
    rendering.depth_m.at<float>(y, x) = static_cast<float>(found->hit.t);
    rendering.labels.at<std::uint16_t>(y, x) = labels[found->body];
    rendering.cosine.at<float>(y, x) =
        static_cast<float>(std::abs(normal.dot(ray.direction.normalized())));
    const bool seen_twice = !caster.Blocked({surface.point, second_eye - surface.point}, 1);
    rendering.in_second_view.at<std::uint8_t>(y, x) = seen_twice ? 255 : 0;
  };
  cv::parallel_for_({0, scene.camera.size_px.height}, [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = 0; x < scene.camera.size_px.width; ++x) render_pixel(x, y);
    }
  });
  return rendering;
}

cv::Mat RenderLabels(const Scene& scene) {
  const std::vector<std::uint16_t> label_of_body = LabelOfEachBody(scene);
  cv::Mat labels = cv::Mat::zeros(scene.camera.size_px, CV_16UC1);
  ForEachHit(scene, [&](int x, int y, const RayCaster::Result& found) {
    labels.at<std::uint16_t>(y, x) = label_of_body[found.body];
  });
  return labels;
}

cv::Mat RenderDepth(const Scene& scene) {
  cv::Mat depth_m(scene.camera.size_px, CV_32FC1, cv::Scalar(std::nan("")));
  ForEachHit(scene, [&](int x, int y, const RayCaster::Result& found) {
    depth_m.at<float>(y, x) = static_cast<float>(found.hit.t);
  });
  return depth_m;
}

}  // namespace fovea::scenes
