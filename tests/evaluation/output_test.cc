#include "tests/evaluation/output.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fovea::evaluation {
namespace {

namespace fs = std::filesystem;

class Output : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("output_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string At(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(Output, IsKnownToBeWritableBefore) {
  EXPECT_EQ(WhyNotWritable(At("scores.json")), "");
  EXPECT_FALSE(fs::exists(At("scores.json")));
  EXPECT_EQ(WhyNotWritable(At("none/scores.json")), At("none/scores.json") + ": cannot be written");
  EXPECT_EQ(WhyNotWritable(folder_.string()), folder_.string() + ": cannot be written");
}

TEST_F(Output, OfBeforeStaysUntilThereIsAnother) {
  WriteText(At("scores.json"), "{}");
  EXPECT_EQ(WhyNotWritable(At("scores.json")), "");
  std::ostringstream text;
  text << std::ifstream(At("scores.json")).rdbuf();
  EXPECT_EQ(text.str(), "{}\n");
}

}  // namespace
}  // namespace fovea::evaluation
