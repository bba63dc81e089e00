// What the detector answers. All positions are in the camera frame (optical: x right, y down,
// z forward) in metres; colours are RGB.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/types/box_uncertainty.h"
#include "core/types/color.h"
#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "core/types/oriented_box.h"
#include "core/types/planning.h"
#include "core/types/shape.h"
#include "core/types/track.h"

namespace fovea {

// The plane n·x + d = 0 that objects stand on; the normal n is a unit vector that points up.
struct SupportSurface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float offset_m = 0;          // d
  std::size_t num_points = 0;  // on it, of those that it was fitted to

  // Signed height of a point above the surface.
  float HeightOf(const Eigen::Vector3f& point) const { return normal.dot(point) + offset_m; }
};

struct Gravity {
  enum class Source { kEstimated, kGiven, kAssumed };    // the last: nothing level is seen
  Eigen::Vector3f direction = Eigen::Vector3f::UnitY();  // unit vector, points down
  Source source = Source::kEstimated;
};

struct ColoredPoint {
  float x = 0, y = 0, z = 0;  // camera frame, metres
  std::uint8_t r = 0, g = 0, b = 0;
};

struct DetectedObject {
  int label = 0;               // 1, 2, … : its value in Detections::labels
  float confidence = 0;        // 0 … 1: the probability that it is an object with this box
  float saliency = 0;          // 0 … 1, mean of the mask's saliency in colour and in depth
  cv::Rect bounds_px;          // smallest upright rectangle around the mask
  std::size_t num_pixels = 0;  // of the mask
  OrientedBox box;             // completed: with what the camera cannot see of its shape; stands on
                               // the support where one was found
  OrientedBox visible_box;     // around what was seen alone, with a yaw of its own
  std::optional<BoxUncertainty> uncertainty;  // of `box`; none where depth is missing
  Shape shape;
  bool yaw_is_arbitrary = false;  // round about the upright: the box's x axis then points away from
                                  // the camera
  float unseen_share = 0;         // of its surface, without the bottom, 0 … 1; 1 without depth
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  // mean of the visible points
  std::array<std::uint8_t, 3> mean_color{};            // RGB
  std::vector<ColorPart> colors;                       // by name, the largest part first
  std::optional<float> height_above_support_m;         // of its lowest point
  bool truncated = false;      // the mask ends with the image, its depth or the region of interest
  bool depth_missing = false;  // of most of the mask: it was seen as a hole in its support, the box
                               // is as deep as wide, and the grasp not more than a proposal
  std::vector<Grasp> grasps;   // of each gripper that was asked for, likeliest first
  std::vector<NoGrasp> no_grasps;  // of the grippers without one
  // What carries it and what must be taken away before it: labels, 0 = a support surface.
  std::vector<int> stands_on, blocked_by;
  std::vector<int> leans_on;                    // labels of the objects that hold it up at its side
  std::optional<CollisionPrimitive> collision;  // encloses it; where planning asks for it
  std::vector<ColoredPoint> cloud;              // one point per mask pixel, row-major order
  std::optional<ObjectTrack> track;  // where frames are tracked (core/tracking/tracker.h)
};

// A position at which an object is looked for.
struct Seed {
  enum class Source { kColorSaliency, kDepthSaliency, kUnexplainedRegion };
  cv::Point pixel;
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Source source = Source::kColorSaliency;
};

// A salient position that did not become a seed.
struct RemovedSeed {
  enum class Reason { kWithoutDepth, kOnSupport };  // on it, below, beside or too high above
  cv::Point pixel;
  Seed::Source source = Seed::Source::kColorSaliency;
  Reason reason = Reason::kOnSupport;
};

// How much was left after each step: says why there are few objects, or none.
struct Diagnostics {
  std::size_t num_pixels = 0;
  std::size_t num_measured = 0;      // pixels with depth in the frame
  std::size_t num_too_far = 0;       // of these, beyond max_depth_m
  std::size_t num_points = 0;        // after hole filling and the range limit
  bool color_is_blank = false;       // profile default: nothing is told apart in it
  std::size_t seeds_from_color = 0;  // regional maxima of the colour saliency map
  std::size_t seeds_from_depth = 0;  // regional maxima of the depth saliency map
  std::size_t seeds_without_depth = 0;
  std::size_t seeds_on_support = 0;
  std::size_t num_seeds = 0;  // that became object hypotheses
  std::size_t num_voxels = 0;
  std::size_t num_segments = 0;          // after the graph cut
  std::size_t num_merged = 0;            // segments that refinement joined to another
  std::size_t segments_implausible = 0;  // what was considered and is not likely enough an object
  std::size_t segments_too_small = 0;
  std::size_t objects_less_salient = 0;  // beyond objects.max_objects
  std::vector<std::string> messages;     // for people: what limited the result, most telling first
};

// Something that was considered and is not reported.
struct RejectedObject {
  cv::Rect bounds_px;     // smallest upright rectangle around it
  float probability = 0;  // that it is an object, 0 … 1
  std::string reason;     // for people: what speaks against it most
};

struct StageTime {
  std::string stage;
  double duration_ms = 0;
};

// Where something of the size that was asked for can be put down.
struct FreePlace {
  OrientedBox box;        // as it would stand there
  float clearance_m = 0;  // around it, to whatever is not seen to be free
};

struct Detections {
  // CV_16UC1, frame size: 0 = background, k = object k; only where depth was measured, or where a
  // hole in the depth of a support is taken for what stands before it
  cv::Mat labels;
  std::vector<DetectedObject> objects;   // by falling confidence; object k has label k
  std::vector<RejectedObject> rejected;  // likeliest first; none in profile "paper"
  Gravity gravity;
  std::optional<SupportSurface> support;  // the dominating one
  std::vector<Gripper> grippers;          // that grasps were planned for
  std::vector<FreePlace> free_places;     // most room first; empty unless asked for
  // Where planning asks for them: below each support, the dominating one first.
  std::vector<CollisionPrimitive> support_collisions;
  std::optional<HeightMap> height_map;
  bool incomplete = false;  // the time budget ended before all of the scene was looked at
  Diagnostics diagnostics;
  std::vector<StageTime> stage_times;  // in the order of the pipeline
  std::optional<Tracking> tracking;    // where frames are tracked
};

}  // namespace fovea
