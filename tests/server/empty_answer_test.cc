// What is unusual and yet a frame gets an answer: from the real detector, with nothing found.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

class EmptyAnswerTest : public ::testing::Test {
 protected:
  v1::Detections ExpectNothing(const v1::DetectRequest& request) {
    v1::Detections detections = loopback_.client.Detect(request).detections();
    EXPECT_EQ(detections.objects_size(), 0);
    EXPECT_GT(detections.diagnostics().messages_size(), 0) << "an empty answer must say why";
    return detections;
  }

  Loopback loopback_;
};

TEST_F(EmptyAnswerTest, ForDepthWithoutMeasurements) {
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_16UC1, std::string(kDepthBytes, '\0'), kWidth, kHeight);
  const v1::Detections detections = ExpectNothing(request);
  EXPECT_EQ(detections.diagnostics().num_measured(), 0U);
  EXPECT_EQ(detections.diagnostics().num_pixels(), kDepthBytes / 2);
}

TEST_F(EmptyAnswerTest, ForOnePixel) {
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_color() = ColorMessage(v1::COLOR_ENCODING_RGB8, "rgb", 1, 1);
  *request.mutable_frame()->mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_16UC1, std::string("\x20\x03", 2), 1, 1);
  ExpectNothing(request);
}

TEST_F(EmptyAnswerTest, ForTheExtremesOfSixteenBits) {
  for (const char byte : {'\xFF', '\x01'}) {
    v1::DetectRequest request = TestRequest();
    *request.mutable_frame()->mutable_depth() =
        DepthMessage(v1::DEPTH_ENCODING_16UC1, std::string(kDepthBytes, byte), kWidth, kHeight);
    EXPECT_NO_THROW(loopback_.client.Detect(request));
  }
}

}  // namespace
}  // namespace fovea::testing
