// Where the camera is, frame by frame, in a frame of reference that stands.
#pragma once

#include <Eigen/Geometry>
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
class CameraPath {
 public:
  struct Place {
    CameraMotion motion;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
    // Standard deviation of where things are that stood still since the frame before.
    double error_m = 0;
  };

  // `pose`: of the camera, in a frame of the robot's choice. The world is the first frame's camera.
  // With poses 0.1 ms, standing 1 ms, else some 15 ms.
  Place Add(const RgbdFrame& frame, const cv::Mat& labels,
            const std::optional<Eigen::Isometry3d>& pose);

 private:
  struct View {
    SmallView small;
    Features features;
    CameraIntrinsics intrinsics;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  };

  Place FromFrames(const RgbdFrame& frame, const cv::Mat& labels);
  bool AddByFeatures(const View& from, int width_px, View& view, Place& place,
                     int* num_inliers) const;

  bool is_first_ = true;
  Eigen::Isometry3d last_world_from_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> last_pose_;
  std::optional<View> key_, last_;  // last_: where that is not the key frame
};

}  // namespace fovea
