// Completion in bash: what a program's --help names is what is offered.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/e2e/process.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

// bash-completion's part, which need not be installed: the words as they were typed, and files.
constexpr const char* kAsk = R"(
_init_completion() {
  words=("${typed[@]}") cword=$((${#typed[@]} - 1))
  cur=${words[cword]} prev=${words[cword - 1]}
}
_filedir() { COMPREPLY=("a file"); }
source "$1"
typed=("${@:2}")
_fovea_program "${typed[0]}"
echo "${COMPREPLY[@]}"
)";

// What is offered for the last word of a command line.
std::string Offered(const std::vector<std::string>& words) {
  std::vector<std::string> command{"bash", "-c", kAsk, "bash",
                                   FOVEA_SOURCE_DIR "/deploy/completion/fovea"};
  command.insert(command.end(), words.begin(), words.end());
  return Execute(command).out;
}

TEST(Completion, OffersSubcommandsAndTheirFlags) {
  EXPECT_EQ(Offered({FOVEA_CLI, ""}), "detect health info options\n");
  EXPECT_EQ(Offered({FOVEA_CLI, "he"}), "health\n");
  EXPECT_EQ(Offered({FOVEA_CLI, "health", "--ser"}), "--server\n");
  EXPECT_EQ(Offered({FOVEA_CLI, "detect", "--color-f"}), "--color-from-depth\n");
  EXPECT_EQ(Offered({FOVEA_CLI, "health", "x"}), "a file\n");
  EXPECT_EQ(Offered({FOVEA_SERVER, "--max-p"}), "--max-pixels --max-per-robot\n");
}

TEST(Completion, OffersWhatIsNewWithoutKnowingIt) {
  const TemporaryFolder folder;
  const std::string kettle = folder.Write("kettle", R"(#!/bin/sh
[ "$1" = brew ] && { echo "  --milk  With it"; exit; }
printf 'Options:\n  --version  Say it\n\nSubcommands:\n  brew  Make tea\n'
)");
  std::filesystem::permissions(kettle, std::filesystem::perms::owner_all);
  EXPECT_EQ(Offered({kettle, ""}), "brew\n");
  EXPECT_EQ(Offered({kettle, "brew", "--"}), "--milk\n");
  EXPECT_EQ(Offered({kettle, "--"}), "--version\n");
}

}  // namespace
}  // namespace fovea::testing
