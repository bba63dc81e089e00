#include "tests/evaluation/tracking/track_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/tracking/assignment.h"
#include "tests/evaluation/tracking/identity_scores.h"

namespace fovea::evaluation {
namespace {

constexpr int kNumThresholds = 19;

double ThresholdAt(int k) { return 0.05 * (k + 1); }

using PerId = std::map<Id, double>;

template <typename Value>
Value At(const PerPair<Value>& values, Id thing, Id track) {
  const auto found = values.find({thing, track});
  return found == values.end() ? Value{} : found->second;
}

// How much a thing and a track belong together over all of the sequence, by which HOTA decides
// where a frame leaves a choice.
PerPair<double> Alignment(const TrackSequence& frames) {
  PerPair<double> common, alignment;
  PerId things, tracks;
  for (const TrackFrame& frame : frames) {
    const Eigen::VectorXd rows = frame.similarity.rowwise().sum();
    const Eigen::RowVectorXd columns = frame.similarity.colwise().sum();
    for (const Id thing : frame.things) ++things[thing];
    for (const Id track : frame.tracks) ++tracks[track];
    for (Eigen::Index i = 0; i < frame.similarity.rows(); ++i) {
      for (Eigen::Index j = 0; j < frame.similarity.cols(); ++j) {
        const double similarity = frame.similarity(i, j);
        if (similarity <= 0) continue;
        common[{frame.things[i], frame.tracks[j]}] +=
            similarity / (rows(i) + columns(j) - similarity);
      }
    }
  }
  for (const auto& [pair, count] : common) {
    alignment[pair] = count / (things[pair.first] + tracks[pair.second] - count);
  }
  return alignment;
}

Matches MatchesOf(const TrackSequence& frames) {
  const PerPair<double> alignment = Alignment(frames);
  Matches matches;
  for (const TrackFrame& frame : frames) {
    Eigen::MatrixXd gains = frame.similarity;
    for (Eigen::Index i = 0; i < gains.rows(); ++i) {
      for (Eigen::Index j = 0; j < gains.cols(); ++j) {
        gains(i, j) *= At(alignment, frame.things[i], frame.tracks[j]);
      }
    }
    matches.push_back(MaximumAssignment(gains));
  }
  return matches;
}

// What ScoreTracks adds up over sequences.
struct Counts {
  double matched = 0, things = 0, tracks = 0;
  double association = 0, association_of_found = 0;  // sums over the matched
};

Counts CountAt(double threshold, const TrackSequence& frames, const Matches& matches) {
  Counts counts;
  PerPair<double> common;
  PerId things, tracks, found_things, found_tracks;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const TrackFrame& frame = frames[f];
    for (const Id thing : frame.things) ++things[thing];
    for (const Id track : frame.tracks) ++tracks[track];
    counts.things += static_cast<double>(frame.things.size());
    counts.tracks += static_cast<double>(frame.tracks.size());
    for (std::size_t i = 0; i < matches[f].size(); ++i) {
      const int j = matches[f][i];
      if (j < 0 || !Reaches(frame.similarity(static_cast<Eigen::Index>(i), j), threshold)) continue;
      ++common[{frame.things[i], frame.tracks[j]}];
      ++found_things[frame.things[i]];
      ++found_tracks[frame.tracks[j]];
    }
  }
  for (const auto& [pair, count] : common) {
    const auto& [thing, track] = pair;
    counts.matched += count;
    counts.association += count * count / (things[thing] + tracks[track] - count);
    counts.association_of_found +=
        count * count / (found_things[thing] + found_tracks[track] - count);
  }
  return counts;
}

}  // namespace

TrackScores ScoreTracks(const std::vector<TrackSequence>& sequences) {
  TrackScores scores;
  std::array<Counts, kNumThresholds> sums;
  Counts half;
  double identity_matches = 0;
  for (std::size_t s = 0; s < sequences.size(); ++s) {
    const TrackSequence& frames = sequences[s];
    const Matches matches = MatchesOf(frames);
    for (int k = 0; k < kNumThresholds; ++k) {
      const Counts counts = CountAt(ThresholdAt(k), frames, matches);
      sums[k].matched += counts.matched;
      sums[k].things += counts.things;
      sums[k].tracks += counts.tracks;
      sums[k].association += counts.association;
    }
    const Counts at_half = CountAt(kHalf, frames, matches);
    half.matched += at_half.matched;
    half.association_of_found += at_half.association_of_found;
    identity_matches += IdentityMatches(frames);
    CountSwitches(s, frames, matches, scores);
  }
  for (const Counts& sum : sums) {
    const double found = std::max(1.0, sum.matched);
    const double detection = sum.matched / std::max(1.0, sum.things + sum.tracks - sum.matched);
    const double association = sum.association / found;
    scores.det_a += detection / kNumThresholds;
    scores.ass_a += association / kNumThresholds;
    scores.hota += std::sqrt(detection * association) / kNumThresholds;
  }
  scores.ass_a_of_found = half.association_of_found / std::max(1.0, half.matched);
  scores.idf1 = 2 * identity_matches / std::max(1.0, sums[0].things + sums[0].tracks);
  return scores;
}

TrackSequence WithTrueIdentities(TrackSequence frames) {
  Id other = 0;
  for (const TrackFrame& frame : frames) {
    for (const Id thing : frame.things) other = std::max(other, thing);
  }
  for (TrackFrame& frame : frames) {
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      frame.tracks[j] = ++other;
      // No two things reach a half of one mask.
      for (std::size_t i = 0; i < frame.things.size(); ++i) {
        const bool is_its =
            frame.similarity(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) > kHalf;
        if (is_its) frame.tracks[j] = frame.things[i];
      }
    }
  }
  return frames;
}

}  // namespace fovea::evaluation
