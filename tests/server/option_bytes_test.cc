#include "server/rpc/option_bytes.h"

#include <gtest/gtest.h>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::testing {
namespace {

std::optional<v1::DetectOptions> OptionsOf(const std::string& message) {
  const grpc::Slice slice(message);
  const auto bytes = server::OptionBytesOf(grpc::ByteBuffer(&slice, 1));
  if (!bytes) return std::nullopt;
  v1::DetectOptions options;
  EXPECT_TRUE(options.ParseFromString(*bytes));
  return options;
}

TEST(OptionBytes, AreThoseOfTheMessage) {
  v1::DetectStreamRequest request;
  request.mutable_frame()->set_id("f");
  EXPECT_FALSE(OptionsOf(request.SerializeAsString()));
  request.mutable_options();
  EXPECT_TRUE(OptionsOf(request.SerializeAsString())) << "to reset them says something, too";
  request.mutable_options()->set_profile("paper");
  EXPECT_EQ(OptionsOf(request.SerializeAsString())->profile(), "paper");
}

TEST(OptionBytes, InPartsAreMerged) {
  v1::DetectStreamRequest first, second;
  first.mutable_options()->set_profile("paper");
  second.mutable_options()->set_return_masks(true);
  const auto options = OptionsOf(first.SerializeAsString() + second.SerializeAsString());
  ASSERT_TRUE(options);
  EXPECT_EQ(options->profile(), "paper");
  EXPECT_TRUE(options->return_masks());
}

TEST(OptionBytes, OfWhatIsNoMessageAreNone) {
  v1::DetectStreamRequest request;
  request.mutable_options()->set_profile("paper");
  const std::string good = request.SerializeAsString();
  for (const std::string& bad : {std::string("\xFF\xFF\xFF"), good.substr(0, good.size() - 1),
                                 good + "\x0B\x0C", good + std::string("\x0A\x7F", 2)}) {
    EXPECT_FALSE(OptionsOf(bad));
  }
}

TEST(OptionBytes, OfWhatWouldTakeLongToReadAreNone) {
  v1::DetectStreamRequest request;
  request.mutable_options()->set_profile(std::string(65 << 10, 'x'));
  EXPECT_FALSE(OptionsOf(request.SerializeAsString()));
  request.mutable_options()->set_profile("paper");
  std::string many = request.SerializeAsString();
  for (int i = 0; i < 100; ++i) many += std::string("\x0A\x00", 2);
  EXPECT_FALSE(OptionsOf(many));
}

TEST(OptionBytes, OfMessagesThatAcceptPicksAreThereToo) {
  v1::DetectStreamRequest request;
  request.mutable_frame()->set_id("f");
  request.mutable_options()->set_profile("paper");
  const auto accepts = [&](const std::string& text) {
    const grpc::Slice slice(text);
    return server::AcceptsPicks(grpc::ByteBuffer(&slice, 1));
  };
  EXPECT_FALSE(accepts(request.SerializeAsString()));
  request.set_accept_picks(true);
  EXPECT_TRUE(accepts(request.SerializeAsString()));
  EXPECT_EQ(OptionsOf(request.SerializeAsString())->profile(), "paper");
  EXPECT_FALSE(accepts("\xFF\xFF\xFF"));
}

}  // namespace
}  // namespace fovea::testing
