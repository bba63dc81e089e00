#include "tests/evaluation/grasp_figures/grasp_report.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/evaluation/grasp_figures/grasp_export.h"

namespace fovea::evaluation {
namespace {

using testing::HasSubstr;

// One can that no gripper is offered a grasp of.
GraspRun RunWith(std::optional<bool> possible) {
  GripperResult none;
  none.possible = possible;
  none.reason = 0;
  GraspRun run;
  run.objects = {{"tabletop", "kinect", "can", "can", 1, 0.95,
                  std::vector<GripperResult>(EvaluationGrippers().size(), none)}};
  run.num_truth = 1;
  return run;
}

std::string TextOf(const GraspRun& run) {
  std::ostringstream text;
  PrintGrasps(text, run);
  return text.str();
}

TEST(GraspReport, SaysWhetherNoneIsRight) {
  const GraspRun run = RunWith(false);
  EXPECT_THAT(TextOf(run), HasSubstr("all                            1      0.0%      0.0%      "
                                     "0.0%         -      0.0%     100.0%      0.0%\n"));
  EXPECT_THAT(TextOf(run), HasSubstr("none, reason (of these impossible): too wide 1 (1),"));
  const nlohmann::json figures = ToJson(run)["grippers"]["jaw 85 mm"]["all"]["all"];
  EXPECT_EQ(figures["possible"], 0);
  EXPECT_EQ(figures["none_right"], 1);
}

TEST(GraspReport, SaysNothingOfWhatWasNotSearched) {
  const GraspRun run = RunWith(std::nullopt);
  EXPECT_THAT(TextOf(run), HasSubstr("all                            1      0.0%      0.0%      "
                                     "0.0%         -         -          -      0.0%\n"));
  EXPECT_THAT(TextOf(run), HasSubstr("none, reason: too wide 1,"));
  const nlohmann::json figures = ToJson(run)["grippers"]["jaw 85 mm"]["all"]["all"];
  EXPECT_FALSE(figures.contains("possible"));
  EXPECT_FALSE(figures.contains("none_right"));
}

}  // namespace
}  // namespace fovea::evaluation
