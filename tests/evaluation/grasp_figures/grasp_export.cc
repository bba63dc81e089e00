#include "tests/evaluation/grasp_figures/grasp_export.h"

#include <nlohmann/json.hpp>

#include "tests/evaluation/grasp_figures/grasp_statistics.h"
#include "tests/evaluation/reliability_report.h"

namespace fovea::evaluation {
namespace {

nlohmann::json ToJson(const GripperFigures& f) {
  nlohmann::json json = {{"objects", f.objects},
                         {"offered", f.offered},
                         {"first_succeeds", f.first},
                         {"any_succeeds", f.any},
                         {"none", f.none}};
  if (f.searched > 0) {
    json["possible"] = f.possible;
    json["none_right"] = f.none_right;
  }
  return json;
}

nlohmann::json ToJson(const GraspedObject& object) {
  nlohmann::json grippers = nlohmann::json::array();
  for (const GripperResult& result : object.grippers) {
    nlohmann::json outcomes = nlohmann::json::array();
    for (const Outcome outcome : result.outcomes) outcomes.push_back(NameOf(outcome));
    nlohmann::json json = {{"outcomes", outcomes},
                           {"probabilities", result.probabilities},
                           {"unseen_ways", result.unseen_ways}};
    if (!result.candidate_outcomes.empty()) {
      for (std::size_t i = 0; i < result.candidate_outcomes.size(); ++i) {
        json["candidates"].push_back(
            {NameOf(result.candidate_outcomes[i]), result.candidate_probabilities[i]});
      }
    }
    if (result.possible) json["possible"] = *result.possible;
    if (result.reason >= 0) json["no_grasp_reason"] = result.reason;
    grippers.push_back(json);
  }
  return {{"kind", object.kind}, {"seed", object.seed},  {"sensor", object.sensor},
          {"name", object.name}, {"class", object.what}, {"visible_share", object.visible_share},
          {"grippers", grippers}};
}

}  // namespace

nlohmann::json ToJson(const GraspRun& run) {
  nlohmann::json json = {{"matched", run.objects.size()}, {"truth", run.num_truth}};
  const std::vector<Gripper> grippers = EvaluationGrippers();
  const auto figures = FiguresOf(run);
  for (std::size_t g = 0; g < grippers.size(); ++g) {
    nlohmann::json& own = json["grippers"][grippers[g].name];
    for (const Grouping& grouping : figures) {
      for (const GroupFigures& group : grouping.groups) {
        nlohmann::json row = ToJson(group.grippers[g]);
        row["this_or_suction"] = group.with_cup[g];
        own[grouping.by][group.name] = row;
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
  const std::vector<GroupFigures> classes = FiguresOf(run)[1].groups;
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
    Series bars = {grippers[g].name, {}, {}};
    for (const GroupFigures& group : classes) {
      bars.y.push_back(100 * group.grippers[g].FirstShare());
    }
    chart.series.push_back(bars);
    right.series.push_back(
        ReliabilityCurve(grippers[g].name, MeasureReliability(PredictionsOf(run, g))));
  }
  return {chart, right};
}

}  // namespace fovea::evaluation
