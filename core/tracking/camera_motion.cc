#include "core/tracking/camera_motion.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/tracking/rigid_motion.h"

namespace fovea {
namespace {

// Robots' poses come from encoders or visual odometry: some millimetres from frame to frame.
constexpr double kPoseError_m = 0.005;
// From the camera to things, which its turns move by their errors.
constexpr double kFar_m = 1;
// Where nothing is known of a motion, it is within what a shaking hand does between two frames.
constexpr double kUnknownError_m = 0.05;
// So many frames that show nothing of it do not end a key frame.
constexpr int kMostLost = 20;
// Beyond that from its key frame, a camera sees less and less of the same.
constexpr double kNear_m = 0.1, kNear_rad = 0.1;
constexpr int kAmpleInliers = 60;
// Between two frames, or from a key frame; more is a mistake.
constexpr double kFarthest_m = 1, kFarthest_rad = 0.8;
// Of poses: what is farther is a map that was found or lost.
constexpr double kFarthestPose_m = 10;

double AngleOf(const Eigen::Isometry3d& motion) {
  return Eigen::AngleAxisd(motion.linear()).angle();
}

bool IsWithin(const Eigen::Isometry3d& motion, double distance_m, double angle_rad) {
  return motion.translation().norm() < distance_m && AngleOf(motion) < angle_rad;
}

// What a robot says may be nonsense; doubles are 0.1 mm apart there, and lose millimetres beyond.
bool IsPlausible(const Eigen::Isometry3d& pose) {
  constexpr double kFarthestPlace_m = 1e12;
  return pose.matrix().allFinite() && pose.translation().norm() <= kFarthestPlace_m;
}

// Of the camera that is at `pose`, in the frame of that at `last`. Positions are subtracted before
// anything else: far from the origin each rounding is of millimetres.
Eigen::Isometry3d MotionBetween(const Eigen::Isometry3d& last, const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d last_from_reference = last.linear().transpose();
  Eigen::Isometry3d motion(last_from_reference * pose.linear());
  motion.translation() = last_from_reference * (pose.translation() - last.translation());
  return motion;
}

std::vector<PointPair> PairsOf(const Features& from, const Features& to,
                               const std::vector<std::pair<int, int>>& matches, bool with_objects) {
  std::vector<PointPair> pairs;
  for (const auto& [i, j] : matches) {
    const bool may_move = from.on_object[i] != 0 || to.on_object[j] != 0;
    if (with_objects || !may_move) {
      pairs.push_back({from.points[i], to.points[j], to.pixels[j]});
    }
  }
  return pairs;
}

}  // namespace

double CameraPath::Place::ErrorAt_m(double distance_m) const {
  const bool turns = motion.source == CameraMotionSource::kGiven;
  return turns ? error_m * std::max(1.0, distance_m / kFar_m) : error_m;
}

CameraPath::Place CameraPath::Add(const RgbdFrame& frame, const cv::Mat& labels,
                                  const std::optional<Eigen::Isometry3d>& pose) {
  const bool has_pose = pose && IsPlausible(*pose);
  Place place;
  if (has_pose && GoesOnByPoses()) {
    place = FromPoses(*pose);
    key_.reset();
    beside_key_.reset();
    num_lost_ = 0;
  } else {
    place = FromFrames(frame, labels);
    if (!place.is_guess()) posed_.reset();
  }
  if (is_first_) place.motion.source = CameraMotionSource::kFirstFrame;
  is_first_ = false;
  if (has_pose) posed_ = {*pose, place.world_from_camera, place.stretch};
  last_has_pose_ = has_pose;
  stretch_before_ = last_.stretch;
  last_ = place;
  return place;
}

CameraPath::Place CameraPath::TakeGuessForTrue() {
  const std::uint64_t guessed = std::exchange(last_.stretch, stretch_before_);
  for (std::optional<View>* view : {&key_, &beside_key_}) {
    if (*view && (*view)->stretch == guessed) (*view)->stretch = last_.stretch;
  }
  if (posed_ && posed_->stretch == guessed) posed_->stretch = last_.stretch;
  last_.motion.source = CameraMotionSource::kEstimated;
  const bool stands = last_.motion.last_from_this.isApprox(Eigen::Isometry3d::Identity());
  last_.error_m = stands ? 0 : kPoseError_m;
  return last_;
}

CameraPath::Place CameraPath::FromPoses(const Eigen::Isometry3d& pose) {
  if (!posed_) return {};
  const Eigen::Isometry3d motion = MotionBetween(posed_->pose, pose);
  if (motion.translation().norm() > kFarthestPose_m) return Guess();
  Place place{
      {CameraMotionSource::kGiven, motion}, posed_->world_from_camera * motion, posed_->stretch};
  // What is said to stand does: arms, and cameras on stands.
  place.error_m = std::min(kPoseError_m, motion.translation().norm() + kFar_m * AngleOf(motion));
  if (!last_has_pose_) {
    place.motion.last_from_this = last_.world_from_camera.inverse() * place.world_from_camera;
  }
  return place;
}

CameraPath::Place CameraPath::Guess() {
  Place place{
      {CameraMotionSource::kUnknown}, last_.world_from_camera, ++num_stretches_, kUnknownError_m};
  // The step to another stretch is none of the camera's, and a very long one is a mistake.
  const Eigen::Isometry3d& step = last_.motion.last_from_this;
  const bool goes_on = last_.motion.source == CameraMotionSource::kGiven &&
                       last_.stretch == stretch_before_ &&
                       IsWithin(step, kFarthest_m, kFarthest_rad);
  if (goes_on) {
    place.motion.last_from_this = step;
    place.world_from_camera = last_.world_from_camera * step;
  }
  return place;
}

CameraPath::Place CameraPath::FromFrames(const RgbdFrame& frame, const cv::Mat& labels) {
  Place place = Guess();
  View view{SmallViewOf(frame, labels), {}, frame.intrinsics};
  if (key_ && IsSameView(key_->small, view.small)) {
    place.motion.source =
        beside_key_ ? CameraMotionSource::kEstimated : CameraMotionSource::kStanding;
    place.world_from_camera = key_->world_from_camera;
    place.stretch = key_->stretch;
    place.error_m = 0;
    beside_key_.reset();
    num_lost_ = 0;
  } else {
    view.features = FindFeatures(frame, labels);
    LookAround(std::move(view), labels.cols, place);
  }
  place.motion.last_from_this = last_.world_from_camera.inverse() * place.world_from_camera;
  return place;
}

void CameraPath::LookAround(View view, int width_px, Place& place) {
  int inliers = 0;
  const bool from_key = key_ && AddByFeatures(*key_, width_px, view, place, &inliers);
  if (!from_key && beside_key_) AddByFeatures(*beside_key_, width_px, view, place, &inliers);
  const bool stands = beside_key_ && IsSameView(beside_key_->small, view.small);
  if (stands && place.is_guess()) {
    place.motion.source = CameraMotionSource::kStanding;
    place.world_from_camera = last_.world_from_camera;
    place.stretch = last_.stretch;
    place.error_m = 0;
  }
  view.world_from_camera = place.world_from_camera;
  view.stretch = place.stretch;
  const bool is_lost = key_ && place.is_guess() && num_lost_ < kMostLost;
  num_lost_ = is_lost ? num_lost_ + 1 : 0;
  const bool keep_key =
      from_key && !stands && inliers >= kAmpleInliers &&
      IsWithin(key_->world_from_camera.inverse() * view.world_from_camera, kNear_m, kNear_rad);
  if (is_lost || keep_key) {
    beside_key_ = std::move(view);
  } else {
    key_ = std::move(view);
    beside_key_.reset();
  }
}

bool CameraPath::AddByFeatures(const View& from, int width_px, const View& view, Place& place,
                               int* num_inliers) {
  const auto matches = MatchFeatures(from.features, view.features);
  for (const bool with_objects : {false, true}) {
    const auto pairs = PairsOf(from.features, view.features, matches, with_objects);
    const auto motion = FindRigidMotion(pairs, view.intrinsics, width_px);
    if (!motion || !IsWithin(motion->to_from_from, kFarthest_m, kFarthest_rad)) continue;
    place.motion.source = CameraMotionSource::kEstimated;
    place.world_from_camera = from.world_from_camera * motion->to_from_from.inverse();
    place.stretch = from.stretch;
    place.error_m = motion->error_m;
    *num_inliers = motion->num_inliers;
    return true;
  }
  return false;
}

}  // namespace fovea
