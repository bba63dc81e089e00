#include "server/rpc/beside_data.h"

#include <gtest/gtest.h>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::testing {
namespace {

constexpr std::size_t kMost = 1000;

std::size_t BesideOf(const std::string& message) {
  const grpc::Slice slice(message);
  return server::BytesBesideData(grpc::ByteBuffer(&slice, 1), *v1::DetectRequest::descriptor(),
                                 kMost);
}

v1::DetectRequest WithImages(std::size_t num_bytes) {
  v1::DetectRequest request;
  request.mutable_frame()->set_id("f1");
  request.mutable_frame()->mutable_color()->set_data(std::string(num_bytes, 'c'));
  request.mutable_frame()->mutable_depth()->set_data(std::string(num_bytes, 'd'));
  (*request.mutable_options()->mutable_parameters())["mrf.lambda"] = 3;
  return request;
}

TEST(BytesBesideData, AreAllButImages) {
  for (const std::size_t num_bytes : {std::size_t{10}, std::size_t{10'000}}) {
    const v1::DetectRequest request = WithImages(num_bytes);
    const std::string message = request.SerializeAsString();
    EXPECT_EQ(BesideOf(message), message.size() - 2 * num_bytes);
  }
  EXPECT_EQ(BesideOf(""), 0U);
}

TEST(BytesBesideData, CountWhatIsUnknown) {
  const std::string groups = "\x7B\x08\x01\x7C";  // number 15, which no request has
  EXPECT_EQ(BesideOf(groups + groups), 2 * groups.size());
  const std::string bytes = std::string("\x7A\x05", 2) + "12345";
  EXPECT_EQ(BesideOf(bytes), bytes.size());
}

// However far they go on.
TEST(BytesBesideData, AreCountedNoFartherThanAsked) {
  v1::DetectRequest request = WithImages(10);
  for (int i = 0; i < 10'000; ++i) request.mutable_options()->mutable_grasps()->add_grippers();
  const std::size_t beside = BesideOf(request.SerializeAsString());
  EXPECT_GT(beside, kMost);
  EXPECT_LT(beside, 2 * kMost);
  request.Clear();
  request.mutable_frame()->set_id(std::string(kMost, 'x'));
  EXPECT_GT(BesideOf(request.SerializeAsString()), kMost);
}

TEST(BytesBesideData, OfWhatIsBrokenEndThere) {
  const std::string good = WithImages(100).SerializeAsString();
  EXPECT_LE(BesideOf(good + "\xFF\xFF"), kMost);
  EXPECT_LE(BesideOf(good.substr(0, good.size() - 3)), kMost);
  EXPECT_LE(BesideOf(std::string(500, '\x7B')), kMost);  // deeper than protobuf reads
}

}  // namespace
}  // namespace fovea::testing
