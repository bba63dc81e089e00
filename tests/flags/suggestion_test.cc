#include "flags/suggestion.h"

#include <gtest/gtest.h>

namespace fovea::flags {
namespace {

TEST(Suggest, FindsWhatWasMeant) {
  const std::vector<std::string> commands{"detect", "health", "info", "options"};
  EXPECT_EQ(Suggest("detct", commands), "detect");
  EXPECT_EQ(Suggest("dectet", commands), "detect");
  EXPECT_EQ(Suggest("opitons", commands), "options");
  EXPECT_EQ(Suggest("infos", commands), "info");
  EXPECT_EQ(Suggest("frames", commands), "");
  EXPECT_EQ(Suggest("", commands), "");
  EXPECT_EQ(Suggest(std::string(1000, 'x'), commands), "");
  EXPECT_EQ(Suggest("--overlai", {"--output", "--overlay"}), "--overlay");
}

}  // namespace
}  // namespace fovea::flags
