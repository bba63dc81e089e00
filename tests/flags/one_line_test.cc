#include "flags/one_line.h"

#include <gtest/gtest.h>

#include <string>

namespace fovea::flags {
namespace {

TEST(OneLine, ShowsControlsAndLeavesAllElse) {
  EXPECT_EQ(OneLine("--robot: \"küche\" C:\\new is 5 °"), "--robot: \"küche\" C:\\new is 5 °");
  EXPECT_EQ(OneLine("a\nb\r\tc\x7F"), "a\\nb\\r\\tc\\x7f");
  EXPECT_EQ(OneLine("\x1B[2J"), "\\x1b[2J");
  EXPECT_EQ(OneLine(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(OneLine("\xC2\x9B"
                    "2J"),
            "\\x9b2J");
  EXPECT_EQ(OneLine("\xC2\xA0\xC3\x9B"), "\xC2\xA0\xC3\x9B");
}

}  // namespace
}  // namespace fovea::flags
