// The frames of a ROS 2 bag.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/bag/bag_file.h"
#include "client/cli/calibration_file.h"
#include "client/cli/frame_list.h"

namespace fovea::cli {

// More than flags allow.
class TooManyImages : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct NamedBagFile {
  std::string name;  // for people
  std::shared_ptr<const BagFile> file;
};

// Topics of a bag, where empty is the only one that can be meant; metres per unit of its depth.
struct BagFlags {
  std::string color_topic = {}, depth_topic = {};
  double depth_unit_m = 0.001;
  // In all topics: each takes half a kilobyte of memory, and some bytes of a chunk.
  std::size_t most_images = 2'000'000;
};

struct Bag {
  FrameList list;  // frames read themselves from the bag, whenever they are asked to
  std::string color_topic, depth_topic, info_topic;
  std::string color_frame, depth_frame;  // the coordinate frames that their first images are of
  std::string camera_info;               // the first message of info_topic; empty = there is none
};

// Reads the bag once to see what it has. Of topics with images, those with "depth" in their names
// are depth (where there are several, those with "aligned" or "registered"), the others, but for
// infrared ones, colour. Images are paired by the times of their headers, else of the recorder.
// Throws std::invalid_argument: why it has no frames, and the topics where it is not clear which
// are meant. Throws TooManyImages.
Bag ReadBag(const std::vector<NamedBagFile>& files, const BagFlags& flags);

// For people, where both headers name a frame and not the same one; else empty.
std::string NoteOfUnregistered(const Bag& bag);

// What the bag says of the colour camera: of rectified images where the topic's name says that they
// are. Nothing where it has no camera_info beside the colour topic; throws std::invalid_argument
// that names the topic where that is of no camera.
std::optional<Calibration> ColorCameraOf(const Bag& bag);

}  // namespace fovea::cli
