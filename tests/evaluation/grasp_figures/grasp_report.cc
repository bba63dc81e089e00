#include "tests/evaluation/grasp_figures/grasp_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <array>

#include "tests/evaluation/grasp_figures/grasp_statistics.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

std::string Percent(int part, int whole) {
  return whole > 0 ? fmt::format("{:.1f}%", 100.0 * part / whole) : "-";
}

void PrintHeader(std::ostream& out, const std::string& title) {
  fmt::print(out, "\n{:24} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9}\n", title, "objects",
             "first", "any of 5", "offered", "of these", "possible", "none right", "or cup");
}

void PrintRow(std::ostream& out, const std::string& name, const GripperFigures& figures,
              int with_cup) {
  fmt::print(out, "{:24} {:7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9}\n", name, figures.objects,
             Percent(figures.first, figures.objects), Percent(figures.any, figures.objects),
             Percent(figures.offered, figures.objects), Percent(figures.first, figures.offered),
             Percent(figures.possible, figures.searched),
             Percent(figures.none_right, figures.searched > 0 ? figures.none : 0),
             Percent(with_cup, figures.objects));
}

// In the order of NoGrasp::Reason.
constexpr std::array<const char*, 9> kReasonNames = {"too wide",        "neighbour", "covered",
                                                     "too low",         "sloped",    "cut",
                                                     "too little seen", "no seal",   "unlikely"};

// Why there are no grasps, and how often the search, if any, agrees that there is none.
void PrintReasons(std::ostream& out, const GraspRun& run, std::size_t gripper) {
  std::array<std::pair<int, int>, kReasonNames.size()> counts = {};
  bool searched = false;
  for (const GraspedObject& object : run.objects) {
    const GripperResult& result = object.grippers[gripper];
    if (result.reason < 0 || !result.outcomes.empty()) continue;
    auto& [count, impossible] = counts.at(static_cast<std::size_t>(result.reason));
    ++count;
    searched |= result.possible.has_value();
    impossible += result.possible && !*result.possible;
  }
  fmt::print(out, "  none, reason{}:", searched ? " (of these impossible)" : "");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto& [count, impossible] = counts[i];
    if (count == 0) continue;
    fmt::print(out, " {} {}{},", kReasonNames[i], count,
               searched ? fmt::format(" ({})", impossible) : "");
  }
  fmt::print(out, "\n");
}

// Of first grasps, those that fail with the highest probabilities: what to look at first.
void PrintWorst(std::ostream& out, const GraspRun& run, std::size_t gripper) {
  constexpr std::size_t kMost = 8;
  std::vector<const GraspedObject*> failures;
  for (const GraspedObject& object : run.objects) {
    const GripperResult& result = object.grippers[gripper];
    if (!result.outcomes.empty() && !result.FirstSucceeds()) failures.push_back(&object);
  }
  const auto probability = [&](const GraspedObject* object) {
    return object->grippers[gripper].probabilities.front();
  };
  std::stable_sort(failures.begin(), failures.end(),
                   [&](const auto* a, const auto* b) { return probability(a) > probability(b); });
  failures.resize(std::min(failures.size(), kMost));
  for (const GraspedObject* object : failures) {
    fmt::print(out, "  fails with {:.2f}: {} {} {}, {} seen to {:.2f}: {}\n", probability(object),
               object->kind, object->seed, object->sensor, object->name, object->visible_share,
               NameOf(object->grippers[gripper].outcomes.front()));
  }
}

void PrintGripper(std::ostream& out, const GraspRun& run, std::size_t gripper) {
  const Reliability reliability = MeasureReliability(PredictionsOf(run, gripper));
  fmt::print(out, "\n{}: calibration error {:.3f}\n", EvaluationGrippers()[gripper].name,
             reliability.calibration_error);
  for (const ReliabilityBin& bin : reliability.bins) {
    if (bin.count == 0) continue;
    fmt::print(out, "  {:.1f} … {:.1f} {:6} grasps, mean {:.3f}, {:5.1f}% succeed\n", bin.low,
               bin.high, bin.count, bin.mean_confidence, 100 * bin.share_correct);
  }
  const std::vector<int> counts = OutcomesOf(run, gripper);
  fmt::print(out, "  first grasps:");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) fmt::print(out, " {} {},", kOutcomeNames[i], counts[i]);
  }
  fmt::print(out, "\n");
  PrintReasons(out, run, gripper);
  PrintWorst(out, run, gripper);
}

}  // namespace

void PrintGrasps(std::ostream& out, const GraspRun& run) {
  fmt::print(out,
             "{} of {} objects matched; stage \"grasps\" {:.2f} ms (90 % below {:.2f}), for ten "
             "objects {:.2f} ms\n",
             run.objects.size(), run.num_truth, Median(run.grasps_ms), Quantile(run.grasps_ms, 0.9),
             LineAt(10, run.num_objects, run.grasps_ms));
  const auto figures = FiguresOf(run);
  const std::vector<Gripper> grippers = EvaluationGrippers();
  for (std::size_t g = 0; g < grippers.size(); ++g) {
    PrintHeader(out, grippers[g].name);
    for (const Grouping& grouping : figures) {
      for (const GroupFigures& group : grouping.groups) {
        PrintRow(out, group.name, group.grippers[g], group.with_cup[g]);
      }
    }
    PrintGripper(out, run, g);
  }
}

}  // namespace fovea::evaluation
