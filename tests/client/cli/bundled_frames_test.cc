#include "client/cli/bundled_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/bundle/bundle.h"
#include "tests/server/frames.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

bundle::BundledFrame Refused(v1::DetectRequest request, grpc::StatusCode code,
                             const std::string& message) {
  bundle::BundledFrame frame{.request = std::move(request), .error = v1::FrameError()};
  frame.error->set_code(code);
  frame.error->set_message(message);
  return frame;
}

FrameList ListOf(std::vector<bundle::BundledFrame> frames) {
  const testing::TemporaryFolder folder;
  return ListBundle(folder.Write("x.zip", bundle::WriteBundle(std::move(frames), {})));
}

std::vector<std::string> NamesOf(const FrameList& list) {
  std::vector<std::string> names;
  for (const FrameFiles& frame : list.frames) names.push_back(frame.id);
  return names;
}

// As those of a robot that has too many under way, of which the server takes the name alone.
TEST(BundledFrames, WithoutImagesArePassedOver) {
  v1::DetectRequest named;
  named.mutable_frame()->set_id("f");
  const FrameList list =
      ListOf({{.request = testing::TestRequest(), .answer = v1::Detections()},
              Refused(named, grpc::StatusCode::RESOURCE_EXHAUSTED, "too many frames"),
              Refused({}, grpc::StatusCode::UNAVAILABLE, "stopping")});
  EXPECT_THAT(NamesOf(list), ElementsAre("frame_0001"));
  EXPECT_THAT(list.notes,
              ElementsAre("frame_0002 was refused before its images came: RESOURCE_EXHAUSTED: too "
                          "many frames; there is nothing to send",
                          "frame_0003 was refused before its images came: UNAVAILABLE: stopping; "
                          "there is nothing to send"));
}

// Whoever sends them once more sees the same again.
TEST(BundledFrames, ThatWereRefusedForWhatTheyAreAreListed) {
  const FrameList list =
      ListOf({Refused({}, grpc::StatusCode::INVALID_ARGUMENT, "frame: is missing"),
              Refused(testing::TestRequest(), grpc::StatusCode::RESOURCE_EXHAUSTED, "too many")});
  EXPECT_THAT(NamesOf(list), ElementsAre("frame_0001", "frame_0002"));
  EXPECT_THAT(list.notes, IsEmpty());
}

}  // namespace
}  // namespace fovea::cli
