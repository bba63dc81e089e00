#include "tests/evaluation/tracking/identity_scores.h"

#include "core/tracking/assignment.h"

namespace fovea::evaluation {

double IdentityMatches(const TrackSequence& frames) {
  PerPair<double> common;
  std::map<Id, Eigen::Index> rows, columns;
  for (const TrackFrame& frame : frames) {
    for (Eigen::Index i = 0; i < frame.similarity.rows(); ++i) {
      for (Eigen::Index j = 0; j < frame.similarity.cols(); ++j) {
        if (!Reaches(frame.similarity(i, j), kHalf)) continue;
        ++common[{frame.things[i], frame.tracks[j]}];
        rows.try_emplace(frame.things[i], static_cast<Eigen::Index>(rows.size()));
        columns.try_emplace(frame.tracks[j], static_cast<Eigen::Index>(columns.size()));
      }
    }
  }
  Eigen::MatrixXd gains = Eigen::MatrixXd::Zero(rows.size(), columns.size());
  for (const auto& [pair, count] : common) gains(rows[pair.first], columns[pair.second]) = count;
  const std::vector<int> assigned = MaximumAssignment(gains);
  double sum = 0;
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    if (assigned[i] >= 0) sum += gains(static_cast<Eigen::Index>(i), assigned[i]);
  }
  return sum;
}

void CountSwitches(std::size_t sequence, const TrackSequence& frames, const Matches& matches,
                   TrackScores& scores) {
  std::map<Id, Id> last;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const TrackFrame& frame = frames[f];
    scores.things += static_cast<int>(frame.things.size());
    for (std::size_t i = 0; i < matches[f].size(); ++i) {
      const int j = matches[f][i];
      if (j < 0 || !Reaches(frame.similarity(static_cast<Eigen::Index>(i), j), kHalf)) continue;
      ++scores.found;
      const auto [before, is_first] = last.try_emplace(frame.things[i], frame.tracks[j]);
      scores.first_found += is_first;
      if (before->second != frame.tracks[j]) {
        scores.switches.push_back({sequence, f, frame.things[i], before->second, frame.tracks[j]});
      }
      before->second = frame.tracks[j];
    }
  }
}

}  // namespace fovea::evaluation
