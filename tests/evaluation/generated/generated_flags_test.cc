#include "tests/evaluation/generated/generated_flags.h"

#include <gtest/gtest.h>

namespace fovea::evaluation {
namespace {

// `fovea-eval grasp-model` has no figures, and took files for them that it did not write.
TEST(GeneratedFlags, HaveFilesWhereThereAreFigures) {
  GeneratedFlags flags;
  CLI::App with, without;
  AddGeneratedFlags(without, flags);
  AddGeneratedFlags(with, flags);
  AddFigureFlags(with, flags);
  for (const char* file : {"--json", "--plot"}) {
    EXPECT_EQ(without.get_option_no_throw(file), nullptr);
    EXPECT_NE(with.get_option_no_throw(file), nullptr);
  }
}

}  // namespace
}  // namespace fovea::evaluation
