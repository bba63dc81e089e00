#include "client/capture/results.h"

#include <gmock/gmock.h>
#include <grpcpp/support/status_code_enum.h>
#include <gtest/gtest.h>

#include <sstream>

namespace fovea::capture {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ResultsTest : public ::testing::Test {
 protected:
  // The lines about an answer with so many objects and this message.
  std::string Take(int objects, const std::string& message) {
    out_.str("");
    Result result;
    v1::Detections& found = *result.response.mutable_detections();
    for (int i = 0; i < objects; ++i) found.add_objects();
    if (objects > 0) found.mutable_support_surface();
    if (!message.empty()) found.mutable_diagnostics()->add_messages(message);
    results_.Take(result, tally_);
    return out_.str();
  }

  std::ostringstream out_;
  Tally tally_;
  Results results_{"", {}, nullptr, out_};
};

TEST_F(ResultsTest, CountsObjects) {
  EXPECT_THAT(Take(1, ""), HasSubstr("  1 object  "));
  EXPECT_THAT(Take(2, ""), HasSubstr("  2 objects  "));
}

TEST_F(ResultsTest, SaysWhyThereAreNoneOnceUntilThatChanges) {
  EXPECT_THAT(Take(0, "only 12.3 % have depth"), HasSubstr("\nnote: only 12.3 % have depth\n"));
  EXPECT_THAT(Take(0, "only 9.8 % have depth"), Not(HasSubstr("note")));
  EXPECT_THAT(Take(0, "nothing stands out"), HasSubstr("note: nothing stands out"));
  EXPECT_THAT(Take(3, "nothing stands out"), Not(HasSubstr("note")));
  EXPECT_THAT(Take(0, "nothing stands out"), HasSubstr("note: nothing stands out"));
}

// Else a misspelt option would fail thirty times a second.
TEST_F(ResultsTest, EndsWhereAllFramesWouldBeRefused) {
  Result result;
  v1::FrameError& error = *result.response.mutable_error();
  error.set_code(grpc::StatusCode::INVALID_ARGUMENT);
  error.set_field("frame.depth.data");
  error.set_message("frame.depth.data: is broken");
  results_.Take(result, tally_);
  error.set_field("options.parameters[no.such]");
  error.set_message("options.parameters[no.such]: there is no such option");
  EXPECT_THROW(results_.Take(result, tally_), std::runtime_error);
  EXPECT_EQ(tally_.Snapshot().failed, 2U);
}

TEST(Panels, FillAWindowOf1280Pixels) {
  const Panels panels = PanelsOf({640, 480});
  EXPECT_EQ(panels.window, cv::Size(1280, 638));
  EXPECT_EQ(panels.answer.area() + panels.color.area() + panels.depth.area(), panels.window.area());
  EXPECT_EQ(panels.color.br().y, panels.depth.y);
}

}  // namespace
}  // namespace fovea::capture
