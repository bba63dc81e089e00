// The parts of track_scores.h at a similarity of one half.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tests/evaluation/tracking/track_scores.h"

namespace fovea::evaluation {

using Id = std::uint64_t;
template <typename Value>
using PerPair = std::map<std::pair<Id, Id>, Value>;  // of thing and track

constexpr double kHalf = 0.5;
inline bool Reaches(double similarity, double threshold) { return similarity >= threshold - 1e-9; }

// In each frame the track of each thing, by index; -1: none.
using Matches = std::vector<std::vector<int>>;

// The most frames that a pairing of things with tracks, one to one, can have in common.
double IdentityMatches(const TrackSequence& frames);

// Adds the sequence's counts and switches to `scores`.
void CountSwitches(std::size_t sequence, const TrackSequence& frames, const Matches& matches,
                   TrackScores& scores);

}  // namespace fovea::evaluation
