// How well tracks keep to the things they began with.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace fovea::evaluation {

// One frame: the things in it, the tracks that were answered, and how like their masks are.
struct TrackFrame {
  std::vector<std::uint64_t> things, tracks;  // ids, each at most once
  Eigen::MatrixXd similarity;                 // things × tracks: intersection over union, 0 … 1
};

using TrackSequence = std::vector<TrackFrame>;

// A thing that was found under another track than the last time.
struct Switch {
  std::size_t sequence = 0, frame = 0;  // indices
  std::uint64_t thing = 0, from = 0, to = 0;
};

struct TrackScores {
  // Luiten et al. 2021, means over the thresholds 0.05, 0.10, … 0.95 of the similarity: HOTA, its
  // parts for detection and association. FNA and FPA, and so ass_a, count frames in which a thing
  // was not found as well as those under another id.
  double hota = 0, det_a = 0, ass_a = 0;
  // The same as ass_a at a similarity of 0.5, of those frames only in which the thing was found:
  // identity without detection.
  double ass_a_of_found = 0;
  // Ristani et al. 2016, at a similarity of 0.5.
  double idf1 = 0;
  // At 0.5: frames in which a thing was found, and those of them with another track than the last
  // time it was found.
  int things = 0, found = 0, first_found = 0;
  std::vector<Switch> switches;

  double SwitchesPer100() const { return things > 0 ? 100.0 * NumSwitches() / things : 0; }
  // Of the frames in which a thing was found again.
  double KeptShare() const {
    const int again = found - first_found;
    return again > 0 ? 1 - static_cast<double>(NumSwitches()) / again : 1;
  }
  int NumSwitches() const { return static_cast<int>(switches.size()); }
};

// Scores sequences together: HOTA's counts and those of the others are added up over them, as no
// thing or track is in two of them.
TrackScores ScoreTracks(const std::vector<TrackSequence>& sequences);

// The same answers as if identities were known: the mask that is most like a thing, by more than a
// half, has the thing's number, any other one of its own. What is lost then, the masks lose.
TrackSequence WithTrueIdentities(TrackSequence frames);

}  // namespace fovea::evaluation
