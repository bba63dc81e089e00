#include "tests/evaluation/reliability.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/evaluation/reliability_report.h"

namespace fovea::evaluation {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

TEST(Reliability, ByHand) {
  const Reliability reliability =
      MeasureReliability({{0.1, false}, {0.3, true}, {0.8, true}, {1.0, false}}, 2);
  ASSERT_EQ(reliability.bins.size(), 2U);
  EXPECT_EQ(reliability.bins[0].count, 2);
  EXPECT_DOUBLE_EQ(reliability.bins[0].mean_confidence, 0.2);
  EXPECT_DOUBLE_EQ(reliability.bins[0].share_correct, 0.5);
  EXPECT_EQ(reliability.bins[1].count, 2);
  EXPECT_DOUBLE_EQ(reliability.bins[1].mean_confidence, 0.9);
  EXPECT_DOUBLE_EQ(reliability.calibration_error, (2 * 0.3 + 2 * 0.4) / 4);
  EXPECT_EQ(reliability.confident, 2);
  EXPECT_DOUBLE_EQ(reliability.share_of_confident, 0.5);
}

TEST(Reliability, OfNothingIsZero) {
  const Reliability reliability = MeasureReliability({});
  EXPECT_EQ(reliability.bins.size(), 10U);
  EXPECT_EQ(reliability.calibration_error, 0);
  EXPECT_EQ(reliability.share_of_confident, 0);
}

TEST(Reliability, WithoutOtherGroupsIsCalibratedOnNone) {
  for (const auto& groups : {std::vector<std::vector<Prediction>>{{{0.9, true}}},
                             std::vector<std::vector<Prediction>>{{{0.9, true}}, {}}}) {
    const ReliabilityReport report = ReportReliability(groups);
    EXPECT_FALSE(report.held_out);
    EXPECT_FALSE(ToJson(report).contains("calibrated_on_other_groups"));
    EXPECT_EQ(ReliabilityChart(report).series.size(), 2U);
    std::ostringstream text;
    PrintReliability(text, report);
    EXPECT_THAT(text.str(), HasSubstr("calibrated on other groups   there are none"));
  }
  EXPECT_TRUE(ReportReliability({{{0.9, true}}, {{0.8, true}}}).held_out);
}

TEST(ReliabilityReport, HasNoShareOfGroupsWithoutConfidentPredictions) {
  const ReliabilityReport report =
      ReportReliability({{{0.5, true}}, {{0.9, false}}, {{0.9, true}}});
  EXPECT_THAT(report.confident_share_of_groups,
              ElementsAre(std::nullopt, Optional(0), Optional(1)));
  std::ostringstream text;
  PrintReliability(text, report);
  EXPECT_THAT(text.str(), HasSubstr("by group        - 0.000 1.000\n"));
  EXPECT_TRUE(ToJson(report)["confident_share_of_groups"][0].is_null());
}

TEST(Calibration, PoolsAdjacentViolators) {
  // 0 | 1 0 → ½ | 1: by rising confidence 0, 1, 0, 1.
  const Calibration calibration =
      FitCalibration({{0.4, false}, {0.1, false}, {0.3, true}, {0.9, true}});
  EXPECT_THAT(calibration.from, ElementsAre(0.1, 0.3, 0.9));
  EXPECT_THAT(calibration.share, ElementsAre(DoubleEq(0), DoubleEq(0.5), DoubleEq(1)));
  EXPECT_EQ(calibration.Of(0.05), 0);
  EXPECT_EQ(calibration.Of(0.29), 0);
  EXPECT_EQ(calibration.Of(0.3), 0.5);
  EXPECT_EQ(calibration.Of(0.89), 0.5);
  EXPECT_EQ(calibration.Of(1), 1);
}

TEST(Calibration, GivesEqualConfidencesOneShare) {
  const Calibration calibration = FitCalibration({{0.5, false}, {0.5, true}, {0.5, true}});
  EXPECT_THAT(calibration.share, ElementsAre(DoubleEq(2.0 / 3)));
  EXPECT_EQ(FitCalibration({}).Of(0.5), 0);
}

TEST(Calibration, OfAGroupComesFromTheOthers) {
  // Each group alone would calibrate itself perfectly; each learns the opposite of itself.
  const std::vector<Prediction> calibrated =
      CalibrateHeldOut({{{0.6, true}}, {{0.6, false}, {0.7, false}}});
  ASSERT_EQ(calibrated.size(), 3U);
  EXPECT_EQ(calibrated[0].confidence, 0);
  EXPECT_TRUE(calibrated[0].correct);
  EXPECT_EQ(calibrated[1].confidence, 1);
  EXPECT_EQ(calibrated[2].confidence, 1);
  EXPECT_FALSE(calibrated[2].correct);
}

}  // namespace
}  // namespace fovea::evaluation
