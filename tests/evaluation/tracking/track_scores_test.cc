#include "tests/evaluation/tracking/track_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/evaluation/tracking/stream_run.h"

namespace fovea::evaluation {
namespace {

// A frame in which thing k is covered by tracks[k], with a similarity of one; 0: it is not found.
TrackFrame Found(const std::vector<std::uint64_t>& tracks) {
  TrackFrame frame;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    frame.things.push_back(i + 1);
    if (tracks[i] != 0) frame.tracks.push_back(tracks[i]);
  }
  frame.similarity = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(frame.things.size()),
                                           static_cast<Eigen::Index>(frame.tracks.size()));
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (tracks[i] != 0) frame.similarity(static_cast<Eigen::Index>(i), column++) = 1;
  }
  return frame;
}

TEST(ScoreTracks, PerfectTracks) {
  const TrackScores scores = ScoreTracks({{Found({7, 8}), Found({7, 8}), Found({7, 8})}});
  EXPECT_DOUBLE_EQ(scores.hota, 1);
  EXPECT_DOUBLE_EQ(scores.ass_a, 1);
  EXPECT_DOUBLE_EQ(scores.idf1, 1);
  EXPECT_EQ(scores.things, 6);
  EXPECT_EQ(scores.NumSwitches(), 0);
  EXPECT_DOUBLE_EQ(scores.KeptShare(), 1);
}

// One thing, four frames, three under 7 and one under 9. TPA of 7 is 3, FNA 1, so that three have
// 3/4; of 9 it is 1, FNA 3, so that one has 1/4: (3 · 3/4 + 1/4) / 4 = 0.625.
TEST(ScoreTracks, ASwitch) {
  const TrackScores scores = ScoreTracks({{Found({7}), Found({7}), Found({7}), Found({9})}});
  EXPECT_DOUBLE_EQ(scores.det_a, 1);
  EXPECT_NEAR(scores.ass_a, 0.625, 1e-12);
  EXPECT_NEAR(scores.hota, std::sqrt(0.625), 1e-12);
  EXPECT_NEAR(scores.idf1, 0.75, 1e-12);
  EXPECT_EQ(scores.NumSwitches(), 1);
  EXPECT_EQ(scores.switches[0].frame, 3U);
  EXPECT_EQ(scores.switches[0].from, 7U);
  EXPECT_EQ(scores.switches[0].to, 9U);
  EXPECT_NEAR(scores.KeptShare(), 2.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(scores.SwitchesPer100(), 25);
}

// A mask that is like two fifths of a thing is another one in each frame.
TEST(WithTrueIdentities, WhatIsLeftIsLostByTheMasks) {
  const TrackSequence switched = {Found({7, 8}), Found({8, 7}), Found({9, 0})};
  const TrackScores scores = ScoreTracks({WithTrueIdentities(switched)});
  EXPECT_EQ(scores.NumSwitches(), 0);
  EXPECT_NEAR(scores.ass_a, (3 + 2 * 2.0 / 3) / 5, 1e-12) << "one is not found once";
  TrackFrame part = Found({7});
  part.similarity(0, 0) = 0.4;
  const TrackSequence parts = WithTrueIdentities({part, part});
  EXPECT_NE(parts[0].tracks, part.things);
  EXPECT_NE(parts[0].tracks, parts[1].tracks);
}

// Two things swap tracks after two of four frames. Of each pair TPA is 2, FNA 2 and FPA 2: 1/3.
TEST(ScoreTracks, ASwap) {
  const TrackScores scores =
      ScoreTracks({{Found({7, 8}), Found({7, 8}), Found({8, 7}), Found({8, 7})}});
  EXPECT_NEAR(scores.ass_a, 1.0 / 3, 1e-12);
  EXPECT_NEAR(scores.idf1, 0.5, 1e-12);
  EXPECT_EQ(scores.NumSwitches(), 2);
}

// Found in three of four frames under one id: nothing is wrong with identity.
TEST(ScoreTracks, AMissIsNoSwitch) {
  const TrackScores scores = ScoreTracks({{Found({7}), Found({0}), Found({7}), Found({7})}});
  EXPECT_NEAR(scores.det_a, 0.75, 1e-12);
  EXPECT_NEAR(scores.ass_a, 0.75, 1e-12);
  EXPECT_DOUBLE_EQ(scores.ass_a_of_found, 1);
  EXPECT_EQ(scores.found, 3);
  EXPECT_EQ(scores.NumSwitches(), 0);
  EXPECT_DOUBLE_EQ(scores.KeptShare(), 1);
}

// A similarity of 0.6 is a match at twelve of the nineteen thresholds, 0.05 … 0.60; where there is
// none, detection and association are 0.
TEST(ScoreTracks, MasksCount) {
  TrackFrame frame = Found({7});
  frame.similarity(0, 0) = 0.6;
  const TrackScores scores = ScoreTracks({{frame, frame}});
  EXPECT_NEAR(scores.det_a, 12.0 / 19, 1e-12);
  EXPECT_NEAR(scores.hota, 12.0 / 19, 1e-12);
  EXPECT_DOUBLE_EQ(scores.idf1, 1);
}

// Two frames of a thing under 7, then, in another sequence, two of another one under another 7.
TEST(ScoreTracks, SequencesAreApart) {
  const TrackSequence sequence = {Found({7}), Found({7})};
  const TrackScores scores = ScoreTracks({sequence, sequence, {Found({8}), Found({8})}});
  EXPECT_DOUBLE_EQ(scores.hota, 1);
  EXPECT_EQ(scores.things, 6);
  EXPECT_EQ(scores.NumSwitches(), 0);
}

TEST(ScoreTracks, NothingAtAll) {
  EXPECT_DOUBLE_EQ(ScoreTracks({}).hota, 0);
  EXPECT_DOUBLE_EQ(ScoreTracks({{Found({0})}}).hota, 0);
  EXPECT_DOUBLE_EQ(ScoreTracks({{Found({0})}}).KeptShare(), 1);
}

// Thing 1 is seen under 7, then not at all, then again: found or not.
TEST(JudgeCovered, TellsLostFromOtherwiseNamed) {
  const auto judged = [](std::uint64_t track_after) {
    TrackedStream stream;
    stream.frames = {Found({7}), Found({}), Found({track_after})};
    JudgeCovered(1, stream);
    EXPECT_TRUE(stream.was_covered);
    return std::pair(stream.is_found_after, stream.is_same_after);
  };
  EXPECT_EQ(judged(7), std::pair(true, true));
  EXPECT_EQ(judged(8), std::pair(true, false));
  EXPECT_EQ(judged(0), std::pair(false, false));
}

TEST(JudgeCovered, CountsNoneThatWasNotFoundBefore) {
  TrackedStream stream;
  stream.frames = {Found({0}), Found({}), Found({7})};
  JudgeCovered(1, stream);
  EXPECT_FALSE(stream.was_covered || stream.is_found_after || stream.is_same_after);
}

}  // namespace
}  // namespace fovea::evaluation
