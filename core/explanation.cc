#include "core/explanation.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace fovea {
namespace {

double Percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string DepthLoss(const Diagnostics& d) {
  if (d.num_measured == 0) {
    return "no pixel has depth: check that depth is sent, its encoding and its unit";
  }
  if (d.num_too_far == d.num_measured) {
    return "every measured depth is beyond max_depth_m: check the depth unit, or raise it";
  }
  if (2 * d.num_points < d.num_measured) {
    if (2 * d.num_too_far > d.num_measured) {
      return "more than half of the measured depth is beyond max_depth_m: raise it, or check the "
             "depth unit";
    }
    return "more than half of the measured depth is no surface (flying_pixels.max_angle_deg) or "
           "beyond max_depth_m: it may be mostly noise";
  }
  const double measured = Percent(d.num_measured, d.num_pixels);
  if (measured < 20) return fmt::format("only {:.1f} % of the pixels have depth", measured);
  return "";
}

// An estimate begins at cameras that are rolled by 30 degrees at most; of one that looks straight
// down or up there is no roll.
std::string OddGravity(const Gravity& gravity) {
  constexpr double kMinLevel = 0.35, kMaxRollDeg = 45;
  const double x = gravity.direction.x(), y = gravity.direction.y();
  if (gravity.source != Gravity::Source::kEstimated || std::hypot(x, y) < kMinLevel) return "";
  const double roll_deg = std::abs(std::atan2(x, y)) * 180 / std::numbers::pi;
  if (roll_deg <= kMaxRollDeg) return "";
  return fmt::format(
      "gravity as it was estimated has the camera rolled by {:.0f} degrees, where estimates are "
      "unreliable: give frame.gravity; if the camera is upright, check that depth is not "
      "disparity, upside down or of another frame",
      roll_deg);
}

std::string NoSupport(const Gravity& gravity) {
  const char* const of_gravity =
      gravity.source == Gravity::Source::kGiven
          ? "frame.gravity does not point down in the camera frame (x right, y down, z forward)"
          : "gravity was estimated wrongly (frame.gravity says it)";
  return fmt::format(
      "no support surface was found: no level surface is large enough, or {}, or the depth unit or "
      "the intrinsics are wrong",
      of_gravity);
}

std::string SeedLoss(const Diagnostics& d, bool has_region) {
  if (d.num_seeds > 0) return "";
  const std::size_t found = d.seeds_from_color + d.seeds_from_depth;
  if (found == 0) {
    return fmt::format(
        "nothing stands out in colour or depth or above a surface{}, so there are no seeds",
        has_region ? " within region.*" : "");
  }
  return fmt::format(
      "none of the {} salient positions became a seed: {} lie where there is no depth up to "
      "max_depth_m, {} on, below or beside the support surface or too high above it{}",
      found, d.seeds_without_depth, d.seeds_on_support,
      has_region ? ", or outside of region.*" : "");
}

// Where nothing is reported.
std::vector<std::string> SegmentLosses(const Diagnostics& d) {
  if (d.num_segments == 0) return {"everything is background, or outside of region.*"};
  std::vector<std::string> losses;
  if (d.segments_too_small > 0) {
    losses.push_back(
        fmt::format("all {} segments that may be objects are smaller than "
                    "objects.min_pixels",
                    d.segments_too_small));
  }
  if (d.segments_implausible > 0) {
    losses.push_back(fmt::format(
        "{} possible objects were considered and are not likely enough: return_rejected (of "
        "fovea detect: --show rejected) tells why, objects.min_probability how likely is enough",
        d.segments_implausible));
  }
  if (losses.empty()) {
    losses.push_back(
        fmt::format("none of {} segments is likely an object and of some size", d.num_segments));
  }
  return losses;
}

}  // namespace

std::vector<std::string> ExplainLosses(const Detections& detections, const Asked& asked) {
  if (detections.incomplete) {
    return {
        "the time budget ended before all of the frame was looked at, what is most salient first: "
        "raise it, or send a smaller image or region"};
  }
  const Diagnostics& d = detections.diagnostics;
  std::vector<std::string> messages;
  const auto say = [&](std::string message) {
    if (!message.empty()) messages.push_back(std::move(message));
  };
  say(DepthLoss(d));
  if (d.num_points == 0) return messages;
  if (d.color_is_blank) {
    say("the colour image shows nothing (too dark, or of one colour): objects are told apart by "
        "their depth alone");
  }
  say(OddGravity(detections.gravity));
  if (!detections.support) say(NoSupport(detections.gravity));
  say(SeedLoss(d, asked.region));
  if (d.objects_less_salient > 0) {
    say(fmt::format("{} less salient objects were left out, as objects.max_objects asks for",
                    d.objects_less_salient));
  }
  if (d.num_seeds > 0 && detections.objects.empty()) {
    for (std::string& loss : SegmentLosses(d)) say(std::move(loss));
  }
  if (asked.place && detections.support && detections.free_places.empty()) {
    say("there is no free place of the size that was asked for, with its margin, on what was seen "
        "of the support surfaces");
  }
  return messages;
}

}  // namespace fovea
