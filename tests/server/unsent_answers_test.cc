#include "server/rpc/unsent_answers.h"

#include <gmock/gmock.h>

#include <string>

namespace fovea::testing {
namespace {

using server::UnsentAnswers;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class UnsentAnswersTest : public ::testing::Test {
 protected:
  UnsentAnswers::Token Add(const std::string& name, std::size_t bytes) {
    return answers_.Add(bytes, [this, name] { cancelled_.push_back(name); });
  }

  UnsentAnswers answers_{100};
  std::vector<std::string> cancelled_;
};

TEST_F(UnsentAnswersTest, CancelsWhatWaitsForLongestUntilAllFits) {
  const auto a = Add("a", 40), b = Add("b", 40), c = Add("c", 20);
  EXPECT_THAT(cancelled_, IsEmpty());
  const auto d = Add("d", 50);
  EXPECT_THAT(cancelled_, ElementsAre("a", "b"));
  const auto e = Add("e", 30);
  EXPECT_THAT(cancelled_, ElementsAre("a", "b")) << "what was cancelled counts no more";
}

TEST_F(UnsentAnswersTest, ForgetsWhatWasSent) {
  auto a = Add("a", 60);
  a.reset();
  const auto b = Add("b", 90);
  EXPECT_THAT(cancelled_, IsEmpty());
}

TEST_F(UnsentAnswersTest, LetsThroughWhatIsLargerThanAll) {
  const auto large = Add("large", 1000);
  EXPECT_THAT(cancelled_, IsEmpty());
  const auto next = Add("next", 1);
  EXPECT_THAT(cancelled_, ElementsAre("large"));
}

// One that was cancelled is taken off once.
TEST_F(UnsentAnswersTest, CountsEachOnce) {
  auto a = Add("a", 80);
  const auto b = Add("b", 80);
  a.reset();
  const auto c = Add("c", 20);
  EXPECT_THAT(cancelled_, ElementsAre("a"));
}

}  // namespace
}  // namespace fovea::testing
