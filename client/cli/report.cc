#include "client/cli/report.h"

#include <fmt/printf.h>

#include <cmath>

#include "client/cli/busy_machine.h"
#include "client/cli/words.h"

namespace fovea::cli {
namespace {

double Norm(const v1::Vector3& v) { return std::hypot(v.x(), v.y(), v.z()); }

std::string Remarks(const v1::Object& object) {
  std::string remarks;
  if (object.track_id() != 0) remarks += fmt::sprintf("  #%llu", object.track_id());
  if (object.moving()) remarks += "  moving";
  if (object.truncated()) remarks += "  cut by the border";
  if (object.depth_missing()) remarks += "  without depth";
  if (!object.blocked_by().empty()) {
    remarks += "  first";
    for (const std::uint32_t label : object.blocked_by()) remarks += fmt::sprintf(" %u", label);
  }
  return remarks;
}

// "82% across, 4.5 cm", of suction without the width; or why there is none.
std::string GraspText(const v1::Object& object) {
  if (!object.grasps().empty()) {
    const v1::Grasp& grasp = object.grasps(0);
    std::string text = fmt::sprintf("%.0f%% %s", grasp.probability() * 100, WordOf(grasp.kind()));
    if (grasp.kind() == v1::GRASP_KIND_SUCTION) return text;
    return text + fmt::sprintf(", %.1f cm", grasp.opening_m() * 100);
  }
  if (object.no_grasps().empty()) return "-";
  return std::string("none: ") + WordOf(object.no_grasps(0).reason());
}

// In the frame of the camera's pose, where that was given.
std::string ReferenceText(const v1::Object& object) {
  if (!object.has_pose_in_reference()) return "";
  const auto& at = object.pose_in_reference().position();
  return fmt::sprintf("%6.3f %6.3f %6.3f     ", at.x(), at.y(), at.z());
}

std::string ObjectLine(const v1::Object& object) {
  const auto& size = object.oriented_box().size();
  const auto& at = object.oriented_box().pose().position();
  return fmt::sprintf(
      "%3u  %4.0f%%  %-8s  %5.1f x %5.1f x %5.1f  %6.3f %6.3f %6.3f  %6.3f  %7u  %s%s%s\n",
      object.label(), object.confidence() * 100, WordOf(object.shape().kind()), size.x() * 100,
      size.y() * 100, size.z() * 100, at.x(), at.y(), at.z(), Norm(at), object.num_pixels(),
      ReferenceText(object).c_str(), GraspText(object).c_str(), Remarks(object).c_str());
}

std::string PlaceLine(const v1::FreePlace& place) {
  const auto& at = place.box().pose().position();
  return fmt::sprintf("free place at (%.3f, %.3f, %.3f), %.0f cm around it\n", at.x(), at.y(),
                      at.z(), place.clearance_m() * 100);
}

// What motion planners asked for.
std::string PlanningLines(const v1::Detections& detections) {
  std::string text;
  if (const int surfaces = detections.support_collisions_size(); surfaces > 0) {
    text += fmt::sprintf("collision primitives of %s and %d support surface%s\n",
                         NumObjects(detections.objects_size()), surfaces, surfaces == 1 ? "" : "s");
  }
  if (!detections.has_height_map()) return text;
  const v1::HeightMap& map = detections.height_map();
  return text + fmt::sprintf("height map of %u x %u cells of %g m\n", map.width(), map.height(),
                             map.cell_m());
}

const char* WordOf(v1::GravitySource source) {
  switch (source) {
    case v1::GRAVITY_SOURCE_REQUEST:
      return "as given";
    case v1::GRAVITY_SOURCE_ASSUMED:
      return "assumed: no depth was looked at that shows it";
    default:
      return "estimated from the scene";
  }
}

std::string GravityLine(const v1::Gravity& gravity) {
  const auto& g = gravity.direction();
  return fmt::sprintf("gravity (%.3f, %.3f, %.3f), %s\n", g.x(), g.y(), g.z(),
                      WordOf(gravity.source()));
}

std::string SupportLine(const v1::Detections& detections) {
  if (!detections.has_support_surface()) {
    const bool none_sought = detections.incomplete() && detections.diagnostics().num_points() == 0;
    return none_sought ? "" : "no support surface was found\n";
  }
  const v1::SupportSurface& support = detections.support_surface();
  // The camera is the origin, so the plane's offset is its height.
  return fmt::sprintf("support surface %.3f m below the camera, %llu points\n",
                      support.plane().offset(), support.num_points());
}

}  // namespace

std::string NumObjects(int number) {
  return std::to_string(number) + (number == 1 ? " object" : " objects");
}

double ServerMs(const v1::Detections& detections) {
  double sum = 0;
  for (const v1::StageTime& stage : detections.stage_times()) {
    if (stage.stage() == kProcessorWait) continue;  // is part of the others
    sum += stage.duration().seconds() * 1e3 + stage.duration().nanos() * 1e-6;
  }
  return sum;
}

std::string Report(const v1::Detections& detections, double round_trip_ms) {
  std::string text =
      fmt::sprintf("%s in %.0f ms (stages of the server: %.0f ms)\n",
                   NumObjects(detections.objects_size()), round_trip_ms, ServerMs(detections));
  if (!detections.objects().empty()) {
    text += "  #  conf.  shape     size L x W x H, cm     centre x, y, z, m     dist.m   pixels  ";
    if (detections.objects(0).has_pose_in_reference()) text += "by --camera-pose, m      ";
    text += "best grasp\n";
  }
  for (const v1::Object& object : detections.objects()) text += ObjectLine(object);
  for (const v1::FreePlace& place : detections.free_places()) text += PlaceLine(place);
  text += PlanningLines(detections);
  text += GravityLine(detections.gravity()) + SupportLine(detections);
  for (const std::string& message : detections.diagnostics().messages()) {
    text += "note: " + message + "\n";
  }
  return text;
}

}  // namespace fovea::cli
