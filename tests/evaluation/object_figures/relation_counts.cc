#include "tests/evaluation/object_figures/relation_counts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace fovea::evaluation {
namespace {

struct MatchedLabels {
  std::map<int, int> of_truth;  // true label → answered label
  std::set<int> answered;
};

MatchedLabels LabelsOf(const GeneratedFrame& frame) {
  MatchedLabels labels;
  for (const MatchedObject& match : frame.matches) {
    labels.of_truth[static_cast<int>(match.truth) + 1] = static_cast<int>(match.answer) + 1;
    labels.answered.insert(static_cast<int>(match.answer) + 1);
  }
  return labels;
}

}  // namespace

void AddRelations(const GeneratedFrame& frame, const std::vector<std::vector<int>>& supports,
                  ObjectRun& run) {
  const MatchedLabels labels = LabelsOf(frame);
  for (const MatchedObject& match : frame.matches) {
    std::set<int> truth, answered, both;
    for (const int below : supports[match.truth]) {
      if (labels.of_truth.contains(below)) truth.insert(labels.of_truth.at(below));
    }
    for (const int below : frame.detections.objects[match.answer].stands_on) {
      if (labels.answered.contains(below)) answered.insert(below);
    }
    std::set_intersection(truth.begin(), truth.end(), answered.begin(), answered.end(),
                          std::inserter(both, both.end()));
    run.on_objects.truth += static_cast<int>(truth.size());
    run.on_objects.answered += static_cast<int>(answered.size());
    run.on_objects.right += static_cast<int>(both.size());
    run.stands_right += truth == answered;
  }
}

void AddLeaning(const std::optional<scenes::LeaningThing>& truth, const GeneratedFrame& frame,
                Relations& leaning) {
  const MatchedLabels labels = LabelsOf(frame);
  std::pair<int, int> true_pair = {0, 0};  // what leans on what, as answered
  if (truth && labels.of_truth.contains(truth->label) && labels.of_truth.contains(truth->against)) {
    true_pair = {labels.of_truth.at(truth->label), labels.of_truth.at(truth->against)};
    ++leaning.truth;
  }
  for (const MatchedObject& match : frame.matches) {
    const DetectedObject& object = frame.detections.objects[match.answer];
    for (const int other : object.leans_on) {
      if (!labels.answered.contains(other)) continue;
      ++leaning.answered;
      leaning.right += true_pair == std::pair(object.label, other);
    }
  }
}

}  // namespace fovea::evaluation
