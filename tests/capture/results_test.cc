#include "client/capture/results.h"

#include <gmock/gmock.h>
#include <grpcpp/support/status_code_enum.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/support/temporary_folder.h"

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

  // The server says that this field is wrong, in its text or also by its name.
  void Refuse(const std::string& field, bool names_field = true) {
    Result result;
    v1::FrameError& error = *result.response.mutable_error();
    error.set_code(grpc::StatusCode::INVALID_ARGUMENT);
    if (names_field) error.set_field(field);
    error.set_message(field + ": is wrong");
    results_.Take(result, tally_);
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
  EXPECT_THAT(Take(3, ""), Not(HasSubstr("note")));
  EXPECT_THAT(Take(0, "nothing stands out"), HasSubstr("note: nothing stands out"));
  EXPECT_THAT(Take(3, "the colour is blank"), HasSubstr("note: the colour is blank"))
      << "of many objects, too";
}

// Else a misspelt option would fail thirty times a second.
TEST_F(ResultsTest, EndsWhereAllFramesWouldBeRefused) {
  for (const char* field :
       {"options.parameters[no.such]", "frame.gravity", "frame.intrinsics.fx",
        "frame.depth_intrinsics", "frame.color_from_depth", "frame.color_from_depth.position",
        "frame.depth", "frame.depth.unit_m", "frame.depth.width"}) {
    EXPECT_THROW(Refuse(field), std::runtime_error) << field;
    EXPECT_THROW(Refuse(field, /*names_field=*/false), std::runtime_error) << field;
  }
  EXPECT_EQ(tally_.Snapshot().failed, 18U);
}

TEST_F(ResultsTest, GoesOnAfterAnImageThatIsBroken) {
  for (const char* field : {"frame.color.data", "frame.depth.data"}) {
    EXPECT_NO_THROW(Refuse(field)) << field;
    EXPECT_NO_THROW(Refuse(field, /*names_field=*/false)) << field;
  }
}

TEST(Results, SayWhichAnswersComeTooLateToBeDrawn) {
  const testing::TemporaryFolder folder;
  std::ostringstream out;
  Tally tally;
  Results results(folder.Path(), {}, nullptr, out);
  Result result;
  result.response.set_frame_id("000001");
  result.response.mutable_detections();
  results.Take(result, tally);
  EXPECT_THAT(out.str(), HasSubstr(", too late to be drawn\n"));
  EXPECT_EQ(tally.Snapshot().answered, 1U);
}

TEST(Results, SaveAFrameWholeOrNotAtAll) {
  const testing::TemporaryFolder folder;
  std::filesystem::create_directories(folder.At("000001.png/in_the_way"));
  std::ostringstream out;
  Tally tally;
  Results results(folder.Path(), {}, nullptr, out);
  Result result;
  result.picture.number = 1;
  result.picture.color = cv::Mat::zeros(2, 2, CV_8UC3);
  result.picture.depth = cv::Mat::zeros(2, 2, CV_16UC1);
  result.response.mutable_detections();
  EXPECT_THROW(results.Take(result, tally), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(folder.At("intrinsics.json")));
  for (const char* name : {"000001_color.png", "000001_depth.png", "000001_overlay.jpg"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.At(name))) << name;
  }
}

TEST(Panels, FillAWindowOf1280Pixels) {
  const Panels panels = PanelsOf({640, 480});
  EXPECT_EQ(panels.window, cv::Size(1280, 638));
  EXPECT_EQ(panels.answer.area() + panels.color.area() + panels.depth.area(), panels.window.area());
  EXPECT_EQ(panels.color.br().y, panels.depth.y);
}

}  // namespace
}  // namespace fovea::capture
