#include "flags/plain_values.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace fovea::flags {
namespace {

// Why this command line is refused; empty = it is not.
std::string Refusal(std::vector<const char*> words) {
  CLI::App app("Test", "program");
  std::string authority;
  int frames = 0;
  app.add_option("--tls-ca", authority);
  app.add_flag("--insecure");
  app.add_subcommand("detect")->add_option("--frames", frames);
  RequirePlainValues(app);
  words.insert(words.begin(), "program");
  const int argc = static_cast<int>(words.size());
  try {
    RequireValuesBehindEquals(argc, words.data());
    app.parse(argc, words.data());
  } catch (const CLI::ParseError& error) {
    return error.what();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// As of "$VARIABLE" that is not set: it would switch protection off, or on what nobody asked for.
TEST(PlainValues, AreNotEmpty) {
  const std::string why = ": is empty; leave it out for what holds without it";
  EXPECT_EQ(Refusal({"--tls-ca", ""}), "--tls-ca" + why);
  EXPECT_EQ(Refusal({"--tls-ca="}), "--tls-ca" + why);
  EXPECT_EQ(Refusal({"--insecure="}), "--insecure" + why);
  EXPECT_EQ(Refusal({"detect", "--frames", ""}), "--frames" + why);
  EXPECT_EQ(Refusal({"--tls-ca", "a=", "--insecure", "detect", "--frames=3"}), "");
  EXPECT_EQ(Refusal({"--tls-ca=a="}), "");
}

TEST(PlainValues, OfNumbersBeginWithNoZero) {
  EXPECT_EQ(Refusal({"detect", "--frames", "010"}), "--frames: \"010\" begins with a zero");
  EXPECT_EQ(Refusal({"detect", "--frames", "0"}), "");
}

}  // namespace
}  // namespace fovea::flags
