// Where the camera is, frame by frame, in a frame of reference that stands.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/tracking/features.h"
#include "core/tracking/still_view.h"
#include "core/types/rgbd_frame.h"
#include "core/types/track.h"

namespace fovea {

// Takes the motion from the poses where two frames in turn have plausible ones (finite, and within
// 1e12 m), else from the frames: the same view is a standing camera, else from features outside of
// objects, or on all of the scene where those do not suffice, against a key frame or else the last
// one. The key frame stays as long as the camera is near it, so that errors do not add up while it
// stands or shakes. Holds two frames' features, some 200 KB; none of frames whose motion comes from
// poses, or of a first one with a pose: if the next has none, its motion is unknown.
//
// What is unknown is guessed: after a motion that poses told as that was, else as standing. The key
// frame and the last pose are kept meanwhile, so that a frame that shows nothing, or whose pose was
// lost, changes nothing for those after it.
class CameraPath {
 public:
  struct Place {
    CameraMotion motion;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
    // Frames with one number are known beside each other, others by a guess at best: a guess begins
    // a new one, and what is known beside a frame before it goes back to that one's.
    std::uint64_t stretch = 0;
    // Standard deviation of where things are that stood still since the last frame of the stretch,
    // or since the frame before where this is a guess.
    double error_m = 0;

    bool is_guess() const { return motion.source == CameraMotionSource::kUnknown; }
    // The error at that distance from the camera: poses err by turns, too, which move what is far
    // farther. What frames tell errs by what they show.
    double ErrorAt_m(double distance_m) const;
  };

  // `pose`: of the camera, in a frame of the robot's choice. The world is the first frame's camera.
  // With poses 0.1 ms, standing 1 ms, else some 15 ms.
  Place Add(const RgbdFrame& frame, const cv::Mat& labels,
            const std::optional<Eigen::Isometry3d>& pose);
  // The last place was a guess and, as things are where that has them, is right: it is of the
  // stretch of the frame before. Returns it.
  Place TakeGuessForTrue();

 private:
  struct View {
    SmallView small;
    Features features;
    CameraIntrinsics intrinsics;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
    std::uint64_t stretch = 0;
  };

  struct Posed {
    Eigen::Isometry3d pose, world_from_camera;
    std::uint64_t stretch = 0;
  };

  bool GoesOnByPoses() const { return is_first_ || posed_; }
  Place FromPoses(const Eigen::Isometry3d& pose);
  Place FromFrames(const RgbdFrame& frame, const cv::Mat& labels);
  Place Guess();
  void LookAround(View view, int width_px, Place& place);
  static bool AddByFeatures(const View& from, int width_px, const View& view, Place& place,
                            int* num_inliers);

  bool is_first_ = true;
  Place last_;
  std::uint64_t stretch_before_ = 0;  // of the frame before last_
  bool last_has_pose_ = false;
  std::optional<Posed> posed_;  // the last one with a pose, and no more than guesses since
  std::optional<View> key_, beside_key_;  // beside_key_: the last frame, where that is not the key
  std::uint64_t num_stretches_ = 0;
  int num_lost_ = 0;  // frames in turn that show nothing of the key frame or the one before
};

}  // namespace fovea
