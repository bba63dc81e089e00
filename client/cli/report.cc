#include "client/cli/report.h"

#include <fmt/printf.h>

#include <cmath>

namespace fovea::cli {
namespace {

double Norm(const v1::Vector3& v) { return std::hypot(v.x(), v.y(), v.z()); }

double ServerMs(const v1::Detections& detections) {
  double sum = 0;
  for (const v1::StageTime& stage : detections.stage_times()) {
    sum += stage.duration().seconds() * 1e3 + stage.duration().nanos() * 1e-6;
  }
  return sum;
}

std::string Remarks(const v1::Object& object) {
  std::string remarks;
  if (object.track_id() != 0) remarks += fmt::sprintf("  #%llu", object.track_id());
  if (object.moving()) remarks += "  moving";
  if (object.truncated()) remarks += "  cut by the border";
  if (object.depth_missing()) remarks += "  without depth";
  return remarks;
}

std::string ObjectLine(const v1::Object& object) {
  const auto& size = object.oriented_box().size();
  const auto& at = object.oriented_box().pose().position();
  const std::string opening =
      object.grasps().empty() ? "-" : fmt::sprintf("%.1f", object.grasps(0).opening_m() * 100);
  return fmt::sprintf("%3u  %4.0f%%  %5.1f x %5.1f x %5.1f  %6.3f %6.3f %6.3f  %6.3f  %7u  %7s%s\n",
                      object.label(), object.confidence() * 100, size.x() * 100, size.y() * 100,
                      size.z() * 100, at.x(), at.y(), at.z(), Norm(at), object.num_pixels(),
                      opening.c_str(), Remarks(object).c_str());
}

std::string GravityLine(const v1::Gravity& gravity) {
  const auto& g = gravity.direction();
  const char* source =
      gravity.source() == v1::GRAVITY_SOURCE_REQUEST ? "as given" : "estimated from the scene";
  return fmt::sprintf("gravity (%.3f, %.3f, %.3f), %s\n", g.x(), g.y(), g.z(), source);
}

std::string SupportLine(const v1::Detections& detections) {
  if (!detections.has_support_surface()) return "no support surface was found\n";
  const v1::SupportSurface& support = detections.support_surface();
  // The camera is the origin, so the plane's offset is its height.
  return fmt::sprintf("support surface %.3f m below the camera, %llu points\n",
                      support.plane().offset(), support.num_points());
}

}  // namespace

std::string NumObjects(int number) {
  return std::to_string(number) + (number == 1 ? " object" : " objects");
}

std::string Report(const v1::Detections& detections, double round_trip_ms) {
  constexpr int kFew = 3;
  std::string text =
      fmt::sprintf("%s in %.0f ms (stages of the server: %.0f ms)\n",
                   NumObjects(detections.objects_size()), round_trip_ms, ServerMs(detections));
  if (!detections.objects().empty()) {
    text += "  #  conf.  size L x W x H, cm     centre x, y, z, m     dist.m   pixels  open.cm\n";
  }
  for (const v1::Object& object : detections.objects()) text += ObjectLine(object);
  text += GravityLine(detections.gravity()) + SupportLine(detections);
  if (detections.objects_size() < kFew || !detections.has_support_surface() ||
      detections.incomplete()) {
    for (const std::string& message : detections.diagnostics().messages()) {
      text += "note: " + message + "\n";
    }
  }
  return text;
}

}  // namespace fovea::cli
