#include "tests/evaluation/tracking/tracking_report.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

const char* NameOf(CameraMotionSource source) {
  switch (source) {
    case CameraMotionSource::kFirstFrame:
      return "first_frame";
    case CameraMotionSource::kGiven:
      return "given";
    case CameraMotionSource::kEstimated:
      return "estimated";
    case CameraMotionSource::kStanding:
      return "standing";
    case CameraMotionSource::kUnknown:
      return "unknown";
  }
  return "";
}

void List(const std::vector<Switch>& switches, const std::vector<StreamSpec>& specs) {
  for (const Switch& each : switches) {
    const StreamSpec& spec = specs[each.sequence];
    std::cout << fmt::format("  {} {} {}: frame {}, thing {}: track {} -> {}\n", spec.motion,
                             spec.kind, spec.seed, each.frame, each.thing, each.from, each.to);
  }
}

}  // namespace

void PrintTrackingHeader() {
  std::cout << fmt::format(
      "{:<8} {:<6} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>8} {:>6} {:>9} {:>7} {:>14} {:>6} {:>6}  "
      "{}\n",
      "motion", "poses", "objects", "found", "HOTA", "DetA", "AssA", "most", "AssAfnd", "IDF1",
      "switch100", "kept%", "same/found/cov", "ms", "ms95", "frames by source of motion");
}

nlohmann::json ReportTracking(const std::vector<StreamSpec>& specs,
                              const std::vector<std::array<TrackedStream, 2>>& streams, Poses poses,
                              bool list_switches) {
  std::vector<TrackSequence> sequences, true_sequences;
  std::vector<double> times_ms;
  std::map<std::string, int> sources;
  int covered = 0, found_after = 0, same = 0;
  for (const auto& both : streams) {
    const TrackedStream& stream = both[static_cast<std::size_t>(poses)];
    sequences.push_back(stream.frames);
    true_sequences.push_back(WithTrueIdentities(stream.frames));
    times_ms.insert(times_ms.end(), stream.times_ms.begin(), stream.times_ms.end());
    for (const auto& [source, frames] : stream.motion_sources) sources[NameOf(source)] += frames;
    covered += stream.was_covered;
    found_after += stream.is_found_after;
    same += stream.is_same_after;
  }
  const TrackScores scores = ScoreTracks(sequences);
  const double most = ScoreTracks(true_sequences).ass_a;
  const std::string& motion = specs.front().motion;
  const char* name = poses == Poses::kGiven ? "given" : "none";
  std::cout << fmt::format(
      "{:<8} {:<6} {:>7} {:>7} {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>8.1f} {:>6.1f} {:>9.2f} "
      "{:>7.2f} "
      "{:>14} {:>6.2f} {:>6.2f} ",
      motion, name, scores.things, scores.found, 100 * scores.hota, 100 * scores.det_a,
      100 * scores.ass_a, 100 * most, 100 * scores.ass_a_of_found, 100 * scores.idf1,
      scores.SwitchesPer100(), 100 * scores.KeptShare(),
      fmt::format("{}/{}/{}", same, found_after, covered), Median(times_ms),
      Quantile(times_ms, 0.95));
  for (const auto& [source, frames] : sources) std::cout << ' ' << source << ' ' << frames;
  std::cout << '\n' << std::flush;
  if (list_switches) List(scores.switches, specs);
  return {{"motion", motion},
          {"poses", name},
          {"streams", streams.size()},
          {"object_frames", scores.things},
          {"found", scores.found},
          {"hota", scores.hota},
          {"det_a", scores.det_a},
          {"ass_a", scores.ass_a},
          {"ass_a_of_true_identities", most},
          {"ass_a_of_found", scores.ass_a_of_found},
          {"idf1", scores.idf1},
          {"switches", scores.NumSwitches()},
          {"switches_per_100", scores.SwitchesPer100()},
          {"kept_share", scores.KeptShare()},
          {"covered", covered},
          {"found_after_cover", found_after},
          {"same_after_cover", same},
          {"median_ms", Median(times_ms)},
          {"p95_ms", Quantile(times_ms, 0.95)},
          {"motion_sources", sources}};
}

}  // namespace fovea::evaluation
