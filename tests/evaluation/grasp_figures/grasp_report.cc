#include "tests/evaluation/grasp_figures/grasp_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/evaluation/generated/visibility.h"
#include "tests/evaluation/reliability.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

using NameOfGroup = std::function<std::string(const GraspedObject&)>;

void Add(GripperFigures& sum, const GripperResult& result) {
  ++sum.objects;
  sum.offered += !result.outcomes.empty();
  sum.first += result.FirstSucceeds();
  sum.any += result.AnySucceeds();
  sum.possible += result.possible.value_or(false);
  if (!result.outcomes.empty()) return;
  ++sum.none;
  sum.none_right += result.possible && !*result.possible;
}

std::vector<GroupFigures> Grouped(const GraspRun& run, const NameOfGroup& name_of) {
  const std::size_t count = EvaluationGrippers().size();
  std::map<std::string, GroupFigures> groups;
  for (const GraspedObject& object : run.objects) {
    const std::string name = name_of(object);
    GroupFigures& group = groups.try_emplace(name, GroupFigures{name, {}, {}}).first->second;
    group.grippers.resize(count);
    group.jaw_or_suction.resize(count - 1);
    for (std::size_t g = 0; g < count; ++g) Add(group.grippers[g], object.grippers[g]);
    for (std::size_t g = 0; g + 1 < count; ++g) {
      group.jaw_or_suction[g] +=
          object.grippers[g].FirstSucceeds() || object.grippers.back().FirstSucceeds();
    }
  }
  std::vector<GroupFigures> list;
  for (auto& [name, group] : groups) list.push_back(std::move(group));
  return list;
}

double Percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0; }

void PrintHeader(std::ostream& out, const std::string& title) {
  fmt::print(out, "\n{:24} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9}\n", title, "objects",
             "first", "any of 5", "offered", "of these", "possible", "none right", "or cup");
}

void PrintRow(std::ostream& out, const std::string& name, const GripperFigures& figures,
              int with_cup) {
  fmt::print(out, "{:24} {:7} {:8.1f}% {:8.1f}% {:8.1f}% {:8.1f}% {:8.1f}% {:9.1f}% {:8.1f}%\n",
             name, figures.objects, Percent(figures.first, figures.objects),
             Percent(figures.any, figures.objects), Percent(figures.offered, figures.objects),
             Percent(figures.first, figures.offered), Percent(figures.possible, figures.objects),
             Percent(figures.none_right, figures.none), Percent(with_cup, figures.objects));
}

int WithCup(const GroupFigures& group, std::size_t g) {
  return g < group.jaw_or_suction.size() ? group.jaw_or_suction[g] : group.grippers[g].first;
}

// First grasps only: what is offered first is what a robot takes.
std::vector<Prediction> PredictionsOf(const GraspRun& run, std::size_t gripper) {
  std::vector<Prediction> predictions;
  for (const GraspedObject& object : run.objects) {
    const GripperResult& result = object.grippers[gripper];
    if (result.outcomes.empty()) continue;
    predictions.push_back({result.probabilities.front(), result.FirstSucceeds()});
  }
  return predictions;
}

std::vector<int> OutcomesOf(const GraspRun& run, std::size_t gripper) {
  std::vector<int> counts(kOutcomeNames.size());
  for (const GraspedObject& object : run.objects) {
    const auto& outcomes = object.grippers[gripper].outcomes;
    if (!outcomes.empty()) ++counts[static_cast<std::size_t>(outcomes.front())];
  }
  return counts;
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
}

nlohmann::json ToJson(const GripperFigures& f) {
  return {{"objects", f.objects},      {"offered", f.offered},   {"first_succeeds", f.first},
          {"any_succeeds", f.any},     {"possible", f.possible}, {"none", f.none},
          {"none_right", f.none_right}};
}

nlohmann::json ToJson(const Reliability& reliability) {
  nlohmann::json bins = nlohmann::json::array();
  for (const ReliabilityBin& bin : reliability.bins) {
    bins.push_back({{"low", bin.low},
                    {"count", bin.count},
                    {"mean_probability", bin.mean_confidence},
                    {"share_right", bin.share_correct}});
  }
  return {{"calibration_error", reliability.calibration_error}, {"bins", bins}};
}

nlohmann::json ToJson(const GraspedObject& object) {
  nlohmann::json grippers = nlohmann::json::array();
  for (const GripperResult& result : object.grippers) {
    nlohmann::json outcomes = nlohmann::json::array();
    for (const Outcome outcome : result.outcomes) outcomes.push_back(NameOf(outcome));
    nlohmann::json json = {{"outcomes", outcomes}, {"probabilities", result.probabilities}};
    if (result.possible) json["possible"] = *result.possible;
    if (result.reason >= 0) json["no_grasp_reason"] = result.reason;
    grippers.push_back(json);
  }
  return {{"kind", object.kind}, {"seed", object.seed},  {"sensor", object.sensor},
          {"name", object.name}, {"class", object.what}, {"visible_share", object.visible_share},
          {"grippers", grippers}};
}

}  // namespace

std::vector<std::vector<GroupFigures>> FiguresOf(const GraspRun& run) {
  return {Grouped(run, [](const auto&) { return "all"; }),
          Grouped(run, [](const auto& object) { return object.what; }),
          Grouped(run, [](const auto& object) { return VisibilityName(object.visible_share); }),
          Grouped(run, [](const auto& object) { return object.sensor; }),
          Grouped(run, [](const auto& object) { return object.kind; })};
}

void PrintGrasps(std::ostream& out, const GraspRun& run) {
  fmt::print(out, "{} of {} objects matched; stage \"grasps\" takes {:.2f} ms, 90 % below {:.2f}\n",
             run.objects.size(), run.num_truth, Median(run.grasps_ms),
             Quantile(run.grasps_ms, 0.9));
  const auto figures = FiguresOf(run);
  const std::vector<Gripper> grippers = EvaluationGrippers();
  for (std::size_t g = 0; g < grippers.size(); ++g) {
    PrintHeader(out, grippers[g].name);
    for (const std::vector<GroupFigures>& groups : figures) {
      for (const GroupFigures& group : groups) {
        PrintRow(out, group.name, group.grippers[g], WithCup(group, g));
      }
    }
    PrintGripper(out, run, g);
  }
}

nlohmann::json ToJson(const GraspRun& run) {
  nlohmann::json json = {{"matched", run.objects.size()}, {"truth", run.num_truth}};
  const std::vector<Gripper> grippers = EvaluationGrippers();
  const char* kGroupings[] = {"all", "class", "visibility", "sensor", "kind"};
  const auto figures = FiguresOf(run);
  for (std::size_t g = 0; g < grippers.size(); ++g) {
    nlohmann::json& own = json["grippers"][grippers[g].name];
    for (std::size_t k = 0; k < figures.size(); ++k) {
      for (const GroupFigures& group : figures[k]) {
        nlohmann::json row = ToJson(group.grippers[g]);
        row["this_or_suction"] = WithCup(group, g);
        own[kGroupings[k]][group.name] = row;
      }
    }
    own["probability"] = ToJson(MeasureReliability(PredictionsOf(run, g)));
    const std::vector<int> counts = OutcomesOf(run, g);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      own["first_outcomes"][kOutcomeNames[i]] = counts[i];
    }
  }
  json["objects"] = nlohmann::json::array();
  for (const GraspedObject& object : run.objects) json["objects"].push_back(ToJson(object));
  return json;
}

std::vector<Chart> GraspCharts(const GraspRun& run) {
  const std::vector<Gripper> grippers = EvaluationGrippers();
  const std::vector<GroupFigures> classes = FiguresOf(run)[1];
  Chart chart, right;
  chart.title = "First grasps that succeed";
  chart.y_label = "%";
  chart.y_max = 100;
  right.title = "Probability of the first grasp";
  right.x_label = "probability";
  right.y_label = "share that succeeds";
  right.series = {{"ideal", {0, 1}, {0, 1}}};
  for (const GroupFigures& group : classes) chart.categories.push_back(group.name);
  for (std::size_t g = 0; g < grippers.size(); ++g) {
    Series bars = {grippers[g].name, {}, {}}, curve = bars;
    for (const GroupFigures& group : classes) {
      bars.y.push_back(100 * group.grippers[g].FirstShare());
    }
    for (const ReliabilityBin& bin : MeasureReliability(PredictionsOf(run, g)).bins) {
      if (bin.count == 0) continue;
      curve.x.push_back(bin.mean_confidence);
      curve.y.push_back(bin.share_correct);
    }
    chart.series.push_back(bars);
    right.series.push_back(curve);
  }
  return {chart, right};
}

}  // namespace fovea::evaluation
