#include "core/explanation.h"

#include <fmt/format.h>

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
    return "every measured depth is beyond max_depth_m: check the depth unit";
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

std::vector<std::string> ExplainLosses(const Detections& detections, bool has_region) {
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
  if (!detections.support) {
    say("no support surface was found: no level surface is large enough, or gravity or the depth "
        "unit is wrong");
  }
  say(SeedLoss(d, has_region));
  if (d.objects_less_salient > 0) {
    say(fmt::format("{} less salient objects were left out, as objects.max_objects asks for",
                    d.objects_less_salient));
  }
  if (d.num_seeds > 0 && detections.objects.empty()) {
    for (std::string& loss : SegmentLosses(d)) say(std::move(loss));
  }
  return messages;
}

}  // namespace fovea
