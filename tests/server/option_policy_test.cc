// Which options requests may change, and what the operator fixes.
#include "server/conversion/option_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/conversion/options.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using server::OptionPolicy;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

std::string ErrorOf(const std::string& clients, const std::vector<std::string>& fixed) {
  try {
    const OptionPolicy policy(clients, fixed);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "valid";
}

grpc::Status StatusWith(const OptionPolicy& policy, const std::string& name, double value) {
  v1::DetectOptions options;
  (*options.mutable_parameters())[name] = value;
  try {
    server::FromProto(options, policy);
  } catch (const std::invalid_argument& error) {
    return {grpc::StatusCode::INVALID_ARGUMENT, error.what()};
  }
  return grpc::Status::OK;
}

TEST(OptionPolicy, NamesWhatIsWrong) {
  EXPECT_EQ(ErrorOf("all", {"mrf.lambda=7", "objects.max_objects=3"}), "valid");
  EXPECT_THAT(ErrorOf("some", {}), HasSubstr("--client-options: \"some\" is not one of"));
  for (const char* option : {"mrf.lambda", "mrf.lambda=", "mrf.lambda=x", "=7", "mrf.lambda=1e9"}) {
    EXPECT_THAT(ErrorOf("all", {option}), StartsWith("--option: ")) << option;
  }
  EXPECT_THAT(ErrorOf("all", {"mrf.lamda=7"}), HasSubstr("mrf.lamda"));
}

TEST(OptionPolicy, BoundsWhatRequestsMayChange) {
  const OptionPolicy none("none", {}), safe("safe", {}), all("all", {});
  EXPECT_TRUE(StatusWith(all, "mrf.lambda", 7).ok());
  EXPECT_THAT(StatusWith(safe, "mrf.lambda", 7).error_message(),
              StartsWith("options.parameters[mrf.lambda]: the operator"));
  EXPECT_TRUE(StatusWith(safe, "objects.max_objects", 3).ok());
  EXPECT_FALSE(StatusWith(none, "objects.max_objects", 3).ok());
  v1::DetectOptions paper;
  paper.set_profile("paper");
  EXPECT_NO_THROW(server::FromProto(paper, safe));
  EXPECT_THROW(server::FromProto(paper, none), std::invalid_argument);
  EXPECT_NO_THROW(server::FromProto({}, none));
}

// They are told by the beginnings of their names: a new one is to be here only if it says where to
// look or what to report.
TEST(OptionPolicy, KnowsWhichOptionsAreSafe) {
  const OptionPolicy safe("safe", {});
  std::vector<std::string> open;
  for (const auto& [name, value] : OptionValues(OptionsOfProfile("default"))) {
    if (StatusWith(safe, name, value).ok()) open.push_back(name);
  }
  EXPECT_THAT(open, UnorderedElementsAre(
                        "region.x_px", "region.y_px", "region.width_px", "region.height_px",
                        "region.min_x_m", "region.max_x_m", "region.min_y_m", "region.max_y_m",
                        "region.min_z_m", "region.max_z_m", "objects.min_probability",
                        "objects.max_objects", "objects.min_pixels", "objects.box.max_gap_m"));
}

TEST(OptionPolicy, FixesOptionsForEveryProfile) {
  const OptionPolicy policy("all", {"mrf.lambda=7"});
  for (const std::string profile : {"default", "paper"}) {
    v1::DetectOptions options;
    options.set_profile(profile);
    EXPECT_EQ(OptionValues(server::FromProto(options, policy)).at("mrf.lambda"), 7) << profile;
  }
  EXPECT_FALSE(StatusWith(policy, "mrf.lambda", 8).ok());
  EXPECT_TRUE(StatusWith(policy, "mrf.cluster_voxels", 3).ok());
}

TEST(OptionPolicy, FixesWhatOneProfileAloneReads) {
  const OptionPolicy policy("all", {"mrf.epsilon=0.3"});
  v1::DetectOptions paper;
  paper.set_profile("paper");
  EXPECT_EQ(OptionValues(server::FromProto(paper, policy)).at("mrf.epsilon"), 0.3);
  EXPECT_NO_THROW(server::FromProto({}, policy));
  EXPECT_THROW(OptionPolicy("all", {"mrf.beta=1"}), std::invalid_argument);
}

TEST(OptionPolicy, HoldsForCallersWhoCanAskForIt) {
  server::ServerOptions options = LoopbackOptions();
  options.client_options = "safe";
  options.fixed_options = {"objects.max_objects=3"};
  const Loopback loopback(FindOne, options);
  v1::DetectRequest request = TestRequest();
  (*request.mutable_options()->mutable_parameters())["mrf.lambda"] = 7;
  const grpc::Status refused = StatusOf([&] { loopback.client.Detect(request); });
  EXPECT_EQ(refused.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_NO_THROW(loopback.client.Detect(TestRequest()));
  const v1::ListOptionsResponse list = loopback.client.ListOptions();
  for (const v1::Option& option : list.options()) {
    const bool open =
        option.name().starts_with("region.") ||
        (option.name().starts_with("objects.") && option.name() != "objects.max_objects");
    EXPECT_EQ(option.fixed(), !open) << option.name();
    if (option.name() == "objects.max_objects") {
      EXPECT_EQ(option.defaults().at("default"), 3);
    }
  }
}

}  // namespace
}  // namespace fovea::testing
