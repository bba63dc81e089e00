#include "tests/evaluation/clean_up/clean_up_report.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace fovea::evaluation {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Two things: one is taken at the second attempt, the first hits it; of the other `left` tells.
CleanedScene SceneWith(const LeftThing& left) {
  Attempt hit, taken;
  hit.name = taken.name = "box";
  hit.outcome = Outcome::kHitsTarget;
  hit.tipped = true;
  taken.outcome = Outcome::kSuccess;
  CleanedScene scene;
  scene.num_things = 2;
  scene.attempts = {hit, taken};
  scene.left = {left};
  return scene;
}

std::string SummaryOf(const CleanedScene& scene) {
  std::ostringstream out;
  PrintSummary(out, {scene});
  return out.str();
}

TEST(CleanUpReport, TellsWhatBecameOfAttempts) {
  const std::string summary = SummaryOf(SceneWith({"bag", "jaw unlikely", false, false}));
  EXPECT_THAT(summary, HasSubstr("50.0% taken, by 2 attempts of which 50.0% succeed and 50.0%"));
  EXPECT_THAT(summary, HasSubstr("1 hits target, tips over\n"));
  EXPECT_THAT(summary, HasSubstr("1 taken\n"));
}

TEST(CleanUpReport, TellsWhetherReasonsAreTrue) {
  const std::string true_one = SummaryOf(SceneWith({"bag", "jaw unlikely", false, false}));
  EXPECT_THAT(true_one, HasSubstr("1 bag: jaw unlikely: true\n"));
  EXPECT_THAT(true_one, HasSubstr("0.0% of the scenes end empty, 100.0% empty or"));
  const std::string wrong = SummaryOf(SceneWith({"bag", "jaw unlikely", true, false}));
  EXPECT_THAT(wrong, HasSubstr("1 bag: jaw unlikely: not true\n"));
  EXPECT_THAT(wrong, HasSubstr(", 0.0% empty or"));
  EXPECT_THAT(SummaryOf(SceneWith({"bag", "", false, false})), HasSubstr("1 bag: not found\n"));
}

// No answer was asked for what is left then.
TEST(CleanUpReport, DoesNotCallNotFoundWhatWasGivenUp) {
  CleanedScene scene = SceneWith({"bag", "", false, false});
  scene.gave_up = true;
  EXPECT_THAT(SummaryOf(scene), HasSubstr("1 bag: given up\n"));
  EXPECT_THAT(SummaryOf(scene), HasSubstr(", 0.0% empty or"));
  std::ostringstream steps;
  PrintSteps(steps, scene);
  EXPECT_THAT(steps.str(), HasSubstr("left bag            given up\n"));
  EXPECT_THAT(steps.str(), Not(HasSubstr("not found")));
  EXPECT_EQ(ToJson({scene})[0]["gave_up"], true);
}

}  // namespace
}  // namespace fovea::evaluation
