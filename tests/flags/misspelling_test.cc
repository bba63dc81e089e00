#include "flags/misspelling.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace fovea::flags {
namespace {

// What the program says of this command line, and its exit code.
std::string Said(const std::vector<const char*>& words) {
  CLI::App app("Test", "program");
  std::string listen;
  app.add_option("--listen", listen);
  app.add_flag("--insecure");
  CLI::App* command = app.add_subcommand("detect");
  command->add_flag("--overlay");
  std::vector<std::string> rest;
  command->add_option("rest", rest);
  const int argc = static_cast<int>(words.size());
  NameMisspellings(app, argc, words.data());
  std::ostringstream out, err;
  try {
    app.parse(argc, words.data());
  } catch (const CLI::ParseError& error) {
    EXPECT_NE(app.exit(error, out, err), 0);
  }
  EXPECT_EQ(out.str(), "");
  return err.str();
}

TEST(NameMisspellings, NamesFlagsAndCommandsThatAreMeant) {
  EXPECT_EQ(Said({"program", "--lisen", "3"}),
            "program: The following arguments were not expected: 3 --lisen; did you mean --listen? "
            "(--help lists the flags)\n");
  EXPECT_NE(Said({"program", "--listne=3"}).find("; did you mean --listen?"), std::string::npos);
  EXPECT_NE(Said({"program", "detct"}).find("; did you mean detect?"), std::string::npos);
  EXPECT_NE(Said({"program", "detect", "--overlai"}).find("; did you mean --overlay?"),
            std::string::npos);
}

TEST(NameMisspellings, DoesNotGuessWhatResemblesNothing) {
  EXPECT_EQ(Said({"program", "--frames", "3"}).find("did you mean"), std::string::npos);
  EXPECT_EQ(Said({"program", "--insecure=maybe"}).find("did you mean"), std::string::npos);
}

TEST(Misspelling, LeavesTheCommandLineOfAnotherProgramAlone) {
  const CLI::App app;
  const std::vector<const char*> words{"program", "--", "--hepl"};
  EXPECT_EQ(Misspelling(app, 3, words.data()), "");
  EXPECT_EQ(Misspelling(app, 1, words.data()), "");
  const std::vector<const char*> ours{"program", "--hepl"};
  EXPECT_EQ(Misspelling(app, 2, ours.data()), "; did you mean --help?");
}

}  // namespace
}  // namespace fovea::flags
