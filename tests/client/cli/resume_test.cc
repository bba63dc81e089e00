#include "client/cli/resume.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

class ResumeTest : public ::testing::Test {
 protected:
  ResumeTest() {
    batch_.input = batch_.output = folder_.At("");
    batch_.resume = true;
    for (const char* name : {"a_color.png", "a_depth.png"}) Write(name, -10);
    for (const char* name : {"a.json", "a.png", "a_overlay.jpg"}) Write(name, -5);
  }

  // Written so many seconds from now.
  void Write(const std::string& name, int seconds) {
    folder_.Write(name, "x");
    fs::last_write_time(folder_.At(name),
                        fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
  }
  std::size_t NumDone() const {
    std::vector<FrameFiles> frames{{.id = "a",
                                    .color_path = folder_.At("a_color.png"),
                                    .depth_path = folder_.At("a_depth.png")}};
    const std::size_t done = LeaveOutDone(batch_, &frames);
    EXPECT_EQ(frames.size(), 1 - done);
    return done;
  }

  testing::TemporaryFolder folder_;
  Batch batch_;
};

TEST_F(ResumeTest, LeavesOutWhatIsDone) {
  EXPECT_EQ(NumDone(), 1U);
  batch_.resume = false;
  EXPECT_EQ(NumDone(), 0U);
}

TEST_F(ResumeTest, DoesAgainWhatHasNoHeightMap) {
  batch_.height_maps = true;
  EXPECT_EQ(NumDone(), 0U);
  Write("a_height.jpg", -5);
  EXPECT_EQ(NumDone(), 1U);
}

TEST_F(ResumeTest, DoesAgainWhatHasNewImages) {
  Write("a_depth.png", -1);
  EXPECT_EQ(NumDone(), 0U);
}

// A run that asked for something else and ended before it came to this frame.
TEST_F(ResumeTest, DoesAgainWhatWasAskedBefore) {
  Write("fovea_request.json", -6);
  EXPECT_EQ(NumDone(), 1U);
  Write("fovea_request.json", -4);
  EXPECT_EQ(NumDone(), 0U);
}

TEST_F(ResumeTest, LeavesTheRequestAsOldAsItIs) {
  const FrameSettings settings;
  batch_.resume = false;
  SaveRequest(batch_, settings);
  const std::string path = folder_.At("fovea_request.json");
  fs::last_write_time(path, fs::last_write_time(path) - std::chrono::hours(1));
  const fs::file_time_type before = fs::last_write_time(path);
  batch_.resume = true;
  SaveRequest(batch_, settings);
  EXPECT_EQ(fs::last_write_time(path), before);
  batch_.resume = false;
  SaveRequest(batch_, settings);
  EXPECT_GT(fs::last_write_time(path), before);
}

// Frames of another folder may have the same names, and be older than the results.
TEST_F(ResumeTest, MixesNoAnswersOfOtherInputs) {
  const FrameSettings settings;
  batch_.resume = false;
  SaveRequest(batch_, settings);
  batch_.resume = true;
  batch_.input = folder_.At(".");  // the same
  SaveRequest(batch_, settings);
  fs::create_directory(folder_.At("other"));
  batch_.input = folder_.At("other");
  EXPECT_THROW(SaveRequest(batch_, settings), std::invalid_argument);
  batch_.resume = false;
  SaveRequest(batch_, settings);
  batch_.resume = true;
  SaveRequest(batch_, settings);
}

TEST_F(ResumeTest, MixesNoAnswersOfOtherTopics) {
  const FrameSettings settings;
  batch_.color_topic = "/left";
  batch_.resume = false;
  SaveRequest(batch_, settings);
  batch_.resume = true;
  SaveRequest(batch_, settings);
  batch_.color_topic = "/right";
  EXPECT_THROW(SaveRequest(batch_, settings), std::invalid_argument);
}

TEST_F(ResumeTest, MixesNoOverlaysThatShowOtherThings) {
  const FrameSettings settings;
  batch_.resume = false;
  batch_.extras.grasps = true;
  SaveRequest(batch_, settings);
  batch_.resume = true;
  batch_.overlays = false;  // none of its own
  SaveRequest(batch_, settings);
  batch_.overlays = true;
  SaveRequest(batch_, settings);
  batch_.extras.grasps = false;
  EXPECT_THROW(SaveRequest(batch_, settings), std::invalid_argument);
}

TEST_F(ResumeTest, AddsOverlaysWhereThereAreNone) {
  const FrameSettings settings;
  batch_.resume = batch_.overlays = false;
  SaveRequest(batch_, settings);
  batch_.resume = batch_.overlays = batch_.extras.seeds = true;
  SaveRequest(batch_, settings);
  batch_.extras.seeds = false;
  EXPECT_THROW(SaveRequest(batch_, settings), std::invalid_argument);
}

TEST_F(ResumeTest, GoesOnWithWhatWasMadeBeforeInputsWereKept) {
  const FrameSettings settings;
  batch_.resume = false;
  SaveRequest(batch_, settings);
  fs::remove(folder_.At("fovea_input.json"));
  batch_.resume = true;
  SaveRequest(batch_, settings);
  batch_.input = folder_.At("other");  // from now on it is known
  EXPECT_THROW(SaveRequest(batch_, settings), std::invalid_argument);
}

TEST_F(ResumeTest, DoesAgainWhatLacksAFile) {
  batch_.clouds = "ply";
  EXPECT_EQ(NumDone(), 0U);
  Write("a.ply", -4);
  EXPECT_EQ(NumDone(), 1U);
  fs::remove(folder_.At("a.png"));
  EXPECT_EQ(NumDone(), 0U);
  batch_.labels = false;
  EXPECT_EQ(NumDone(), 1U);
}

// What was read from a bag or a bundle is as old as that.
TEST_F(ResumeTest, DoesAgainWhatComesFromANewerBag) {
  Write("frames.mcap", -10);
  batch_.input = folder_.At("frames.mcap");
  std::vector<FrameFiles> frames{{.id = "a", .read_color = [] { return std::string(); }}};
  EXPECT_EQ(LeaveOutDone(batch_, &frames), 1U);
  Write("frames.mcap", -1);
  frames = {{.id = "a", .read_color = [] { return std::string(); }}};
  EXPECT_EQ(LeaveOutDone(batch_, &frames), 0U);
}

}  // namespace
}  // namespace fovea::cli
