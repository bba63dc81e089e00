// What the server takes of its configuration file, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/config_file.h"
#include "tests/e2e/server_process.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ServerConfig, ReadsItsConfigurationFromAFile) {
  const ConfigFile file("# ours\nlisten = \"127.0.0.1:0\"\nlog-level = \"debug\"\n");
  Process server({FOVEA_SERVER, "--config", file.path()});
  EXPECT_THAT(server.ReadLine(), StartsWith("listening on 127.0.0.1:"));
}

void ExpectRefused(const std::string& text, const std::string& error) {
  const ConfigFile bad(text);
  const Finished invalid = Execute({FOVEA_SERVER, "--check-config", "--config", bad.path()});
  EXPECT_EQ(invalid.exit_code, 1) << text;
  EXPECT_THAT(invalid.err, HasSubstr(error)) << text;
}

TEST(ServerConfig, ChecksItsConfiguration) {
  const ConfigFile good(
      "\xEF\xBB\xBFmax-pixels = 1000\ninsecure = false\noption = [\"mrf.lambda=0.5\"]\n");
  const Finished valid = Execute({FOVEA_SERVER, "--check-config", "--config", good.path()});
  EXPECT_EQ(valid.exit_code, 0) << valid.err;
  EXPECT_EQ(valid.out, "the configuration is valid\n");

  const Finished closed = Execute({FOVEA_SERVER, "--check-config", "--tokens", "/dev/null"});
  EXPECT_EQ(closed.exit_code, 0) << closed.err;
  EXPECT_THAT(
      closed.out,
      HasSubstr("--tokens: /dev/null holds 0 tokens that have not expired: nobody may call"));

  const std::vector<std::pair<std::string, std::string>> cases{
      {"max-pixels = 0\n", "--max-pixels: 0 is not between 1 and 100000000"},
      {"max-pixels = many\n",
       ":1: \"max-pixels\" is not a whole number between 1 and 100000000: \"many\""},
      {"\nmax-pixels = 99999999999999999999\n",
       ":2: \"max-pixels\" is not a whole number between 1"},
      {"max-streams = 99999999999\n", "is not a whole number between 1 and 10000: \"99999999999\""},
      {"max-streams = 1.5\n", "is not a whole number between 1 and 10000: \"1.5\""},
      {"trace-share = half\n", ":1: \"trace-share\" is not a number between 0 and 1: \"half\""},
      {"listen = \"unix:/" + std::string(200, 'x') + "\"\n", "has a path of more than 107 bytes"},
      {"max-receiving-mib = 64\n",
       "--max-receiving-mib: 64 is less than six messages of "
       "--max-message-mib (24)"},
      {"max-compute-ms = \"\"\n", "--max-compute-ms: is empty"},
      {"tokens = \"\"\n", "--tokens: is empty"},
      {"max-message-mib = 010\n", "--max-message-mib: \"010\" begins with a zero"},
      {"\ninsecure = \"\"\n", ":2: \"insecure\" must be true or false"},
      {"# one\nhold-s = [5, 6]\n", ":2: \"hold-s\" must be one value, not a list of several"},
      {"insecure = 5\n", "\"insecure\" must be true or false"},
      {"\n max-pixel = 1000\n", ":2: \"max-pixel\" is no key; did you mean max-pixels?"},
      {"hold-s = 1\nmrf.lambda = 3\n", ":2: \"mrf.lambda\" is no key; options of the method come"},
      {"fast = true\n", ":1: \"fast\" is no key; --help lists"},
      {"[section]\nlisten = \"127.0.0.1:0\"\n", ":1: \"section\" is no key"},
      {"[mrf]\nlambda = 3\n", ":1: \"mrf\" is no key; options of the method come"},
      {"listen = \"[::1]:0\"\n# more\nlisten = \"127.0.0.1:0\"\n", ":3: \"listen\" is there twice"},
      {"insecure = true\ninsecure = false\n", ":2: \"insecure\" is there twice"},
      {"hold-s = 1\noption = [\n  \"mrf.lambda=7\",\n]\n",
       ":2: \"option\" is a list that must end in its line"},
      {"option = [\"mrf.lambda=7\", # ]\n  \"mrf.alpha=1\"]\n",
       ":1: \"option\" is a list that must end in its line"},
      {"check-config = true\n", ":1: \"check-config\" is for the command line only"}};
  for (const auto& [text, error] : cases) ExpectRefused(text, error);
  const ConfigFile large(std::string((1 << 20) + 1, '#'));
  const Finished too_large = Execute({FOVEA_SERVER, "--check-config", "--config", large.path()});
  EXPECT_THAT(too_large.err, HasSubstr("--config: the file has more than 1 MiB"));
  const Finished unset = Execute({FOVEA_SERVER, "--check-config", "--tokens", ""});
  EXPECT_THAT(unset.err, HasSubstr("--tokens: is empty"));
  const Finished missing = Execute({FOVEA_SERVER, "--config", "/nowhere.toml"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err,
              StartsWith("fovea-server: --config: cannot read /nowhere.toml: No such file"));
}

// CLI11 takes a key alone for true, and skips what it cannot make anything of.
TEST(ServerConfig, RefusesLinesOfItsConfigurationThatSayNothing) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"listen = \"127.0.0.1:0\"\ninsecure\n", ":2: \"insecure\" has no value"},
      {"\"insecure\"\n", "has no value"},
      {"insecure # = true\n", ":1: \"insecure\" has no value"},
      {"max-streams\n", ":1: \"max-streams\" has no value"},
      {"listen =\n", ":1: \"listen\" has no value"},
      {"listen = []\n", ":1: \"listen\" must be a list of values"},
      {"=7\n", ":1: there is no key before ="},
      {"[x\n", ":1: \"[x\" has no value"},
      {"\nx]\n", ":2: \"x]\" has no value"},
      {"\xFF\n", "has no value"},
      {"[]\n", ":1: \"[]\" has no value"},
      {"[Default]\nhold-s = 1\n", ":1: \"[Default]\" has no value"},
      {"; ours\n", ":1: comments begin with #"},
      {"max-streams = 7,\n", ":1: \"max-streams\" must be one value"},
      {"listen = 127.0.0.1:0, 127.0.0.2:0\n", ":1: \"listen\" must be one value"},
      {"listen = \"127.0.0.1:0\" unix:/x\n", ":1: \"listen\" must be one value"},
      {"tls-cert = \"/a # b\"\n", ":1: \"tls-cert\" must be one value"},
      {"option = [\"mrf.lambda=0.5\" \"mrf.alpha=1\"]\n",
       ":1: \"option\" must be a list of values"},
      {"option = [\"mrf.lambda=0.5\",]\n", ":1: \"option\" must be a list of values"},
      {"option = [\"mrf.lambda=0.5]\n", ":1: \"option\" must be a list of values"}};
  for (const auto& [text, error] : cases) ExpectRefused(text, error);
  const ConfigFile good(
      " # ours\n\r\n\thold-s\t=\t1 # s\r\noption = [ 'mrf.lambda=0.5', \"mrf.alpha=1\" ]\n"
      "gripper = 'a={\"jaw\": {\"max_opening_m\": 0.1, \"finger_width_m\": 0.02}}'\nlog-level = "
      "debug");
  const Finished valid = Execute({FOVEA_SERVER, "--check-config", "--config", good.path()});
  EXPECT_EQ(valid.out, "the configuration is valid\n") << valid.err;
}

TEST(ServerConfig, ShowsWhatAFlagHasWithItsFile) {
  const ConfigFile file("max-pixels = 1000\nmetrics-listen = \"127.0.0.1:9000\"\n");
  const auto shown = [&](const std::string& key) {
    return Execute({FOVEA_SERVER, "--config", file.path(), "--max-pixels", "2000", "--show", key});
  };
  EXPECT_EQ(shown("metrics-listen").out, "127.0.0.1:9000\n");
  EXPECT_EQ(shown("max-pixels").out, "2000\n");
  EXPECT_EQ(shown("listen").out, "127.0.0.1:50051\n");
  EXPECT_EQ(shown("insecure").out, "false\n");
  EXPECT_EQ(shown("tokens").out, "\n");
  EXPECT_EQ(shown("tokens").exit_code, 0);
  const Finished traced = Execute({FOVEA_SERVER, "--trace-endpoint", "http://a:4318/v1?key=secret",
                                   "--show", "trace-endpoint"});
  EXPECT_EQ(traced.out, "http://a:4318/v1?...\n");
}

}  // namespace
}  // namespace fovea::testing
