// The camera's motion where poses are lost or frames show nothing.
#include <gtest/gtest.h>

#include <cstdint>

#include "core/tracking/camera_motion.h"
#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::AddAt;
using testing::PoseAt;
using testing::View;
using enum CameraMotionSource;

// Where one pose is lost, the camera is guessed to go on, and then is where the next one says.
TEST(CameraPath, ALostPoseChangesNothingForThoseAfterIt) {
  CameraPath path;
  AddAt(path, 0, 1, PoseAt(0));
  const CameraPath::Place before = AddAt(path, 0.04, 2, PoseAt(0.05));
  const CameraPath::Place guess = AddAt(path, 0.08, 3);
  EXPECT_TRUE(guess.is_guess());
  EXPECT_NEAR(guess.world_from_camera.translation().x(), 0.1, 1e-9);
  const CameraPath::Place again = AddAt(path, 0.08, 4, PoseAt(0.12));
  EXPECT_EQ(again.motion.source, kGiven);
  EXPECT_NE(guess.stretch, again.stretch);
  EXPECT_EQ(again.stretch, before.stretch);
  EXPECT_LE(again.error_m, 0.005);
  EXPECT_NEAR(again.world_from_camera.translation().x(), 0.12, 1e-9);
  EXPECT_NEAR(again.motion.last_from_this.translation().x(), 0.02, 1e-9);
  const CameraPath::Place next = AddAt(path, 0.08, 5, PoseAt(0.16));
  EXPECT_EQ(next.stretch, before.stretch);
  EXPECT_NEAR(next.motion.last_from_this.translation().x(), 0.04, 1e-9);
}

// Nor does what was guessed longer ago: the frames have told how the camera went on since.
TEST(CameraPath, DoesNotGoBackToPosesBeforeFramesThatTold) {
  CameraPath path;
  AddAt(path, 0, 1, PoseAt(0));
  AddAt(path, 0, 2, PoseAt(0));
  AddAt(path, 0, 3);
  EXPECT_EQ(AddAt(path, 0.04, 4).motion.source, kEstimated);
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  EXPECT_TRUE(path.Add(blank.frame, blank.detections.labels, {}).is_guess());
  const CameraPath::Place place = AddAt(path, 0.08, 5, PoseAt(7));
  EXPECT_EQ(place.motion.source, kEstimated);
  EXPECT_NEAR(place.world_from_camera.translation().x(), 0.08, 0.006);
}

TEST(CameraPath, AFrameThatShowsNothingChangesNothingForThoseAfterIt) {
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  for (const double x_m : {0.0, 0.04}) {
    CameraPath path;
    const CameraPath::Place before = AddAt(path, 0, 1);
    EXPECT_NE(path.Add(blank.frame, blank.detections.labels, {}).stretch, before.stretch);
    EXPECT_TRUE(path.Add(blank.frame, blank.detections.labels, {}).is_guess());
    const CameraPath::Place place = AddAt(path, x_m, 2);
    EXPECT_EQ(place.motion.source, kEstimated);
    EXPECT_EQ(place.stretch, before.stretch);
    EXPECT_NEAR(place.world_from_camera.translation().x(), x_m, 0.004);
    EXPECT_EQ(AddAt(path, x_m, 3).stretch, before.stretch);
  }
}

// The frame to which they go back was a guess itself.
TEST(CameraPath, IsNotBackBeyondAGuess) {
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  CameraPath by_frames;
  const std::uint64_t posed = AddAt(by_frames, 0, 1, PoseAt(0)).stretch;
  AddAt(by_frames, 0, 2, PoseAt(0));
  const CameraPath::Place guess = AddAt(by_frames, 0, 3);
  EXPECT_TRUE(guess.is_guess());
  by_frames.Add(blank.frame, blank.detections.labels, {});
  const CameraPath::Place as_guessed = AddAt(by_frames, 0, 4);
  EXPECT_EQ(as_guessed.stretch, guess.stretch);
  EXPECT_NE(as_guessed.stretch, posed);

  CameraPath by_poses;
  const std::uint64_t first = AddAt(by_poses, 0, 1, PoseAt(0)).stretch;
  const CameraPath::Place jump = AddAt(by_poses, 0, 2, PoseAt(11));
  AddAt(by_poses, 0, 3);
  const CameraPath::Place after = AddAt(by_poses, 0, 4, PoseAt(11.1));
  EXPECT_EQ(after.motion.source, kGiven);
  EXPECT_EQ(after.stretch, jump.stretch);
  EXPECT_NE(after.stretch, first);
}

// Dark for longer than that, the key frame is given up.
TEST(CameraPath, IsNotBackAfterManyFramesThatShowNothing) {
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  for (const int dark : {20, 21}) {
    CameraPath path;
    const std::uint64_t first = AddAt(path, 0, 1).stretch;
    for (int i = 0; i < dark; ++i) path.Add(blank.frame, blank.detections.labels, {});
    EXPECT_EQ(AddAt(path, 0, 2).stretch == first, dark == 20) << dark;
  }
}

// A map that was corrected is not a camera that goes on so.
TEST(CameraPath, AVeryLongStepIsNotGuessedToGoOn) {
  CameraPath path;
  AddAt(path, 0, 1, PoseAt(0));
  AddAt(path, 0, 2, PoseAt(3));
  EXPECT_NEAR(AddAt(path, 0, 3).world_from_camera.translation().x(), 3, 1e-9);
}

// Elsewhere, which the key frame does not show.
TEST(CameraPath, GoesOnFromAFrameWhosePlaceIsNotKnown) {
  CameraPath path;
  const CameraPath::Place before = AddAt(path, 0, 1), guess = AddAt(path, 1.9, 2);
  EXPECT_TRUE(guess.is_guess());
  const CameraPath::Place place = AddAt(path, 1.94, 3);
  EXPECT_EQ(place.motion.source, kEstimated);
  EXPECT_NE(place.stretch, before.stretch);
  EXPECT_EQ(place.stretch, guess.stretch);
  EXPECT_NEAR(place.motion.last_from_this.translation().x(), 0.04, 0.004);
}

}  // namespace
}  // namespace fovea
