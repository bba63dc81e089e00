#include "client/cli/bag/bag.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "client/cli/bag/camera_info.h"
#include "client/cli/bag/decompression.h"
#include "client/cli/bag/message_header.h"
#include "client/cli/bag/ros_images.h"
#include "client/cli/bag/topics.h"
#include "client/cli/timed_images.h"

namespace fovea::cli {
namespace {

constexpr std::string_view kImage = "sensor_msgs/msg/Image";
constexpr std::string_view kCompressed = "sensor_msgs/msg/CompressedImage";
constexpr std::string_view kInfo = "sensor_msgs/msg/CameraInfo";

struct BrokenImages {
  int number = 0;
  std::string first;  // "image 3 of /rgb: it ends too early"
};

struct ImagePlace {
  std::shared_ptr<const BagFile> file;
  MessagePlace at;
  bool is_compressed = false;

  std::string Data() const { return Unpacked(file->DataAt(at)); }
};

struct Index {
  std::map<std::string, std::vector<TimedImage>, std::less<>> images;  // by topic
  std::map<std::string, std::string, std::less<>> infos;               // the first message each
  std::map<std::string, std::string, std::less<>> frames;              // of the first image each
  std::map<std::string, ImagePlace> places;                            // by TimedImage.path
  std::map<std::string, BrokenImages, std::less<>> broken;             // by topic
};

// A few bytes of a compressed chunk may be any number of images, and texts of any size.
constexpr std::size_t kLargestHead = std::size_t{1} << 16;

std::int64_t TimeOf(const Header& header, const BagMessage& message) {
  constexpr std::int64_t kLatest = 4'000'000'000'000'000'000;  // the year 2096
  const std::int64_t time = header.stamp_ns != 0 ? header.stamp_ns : message.log_time_ns;
  if (time < 0 || time > kLatest) throw std::invalid_argument("an image's time is none");
  return time;
}

std::string Seconds(std::int64_t time_ns) {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  return fmt::format("{}.{:09}", time_ns / kNsPerSecond, time_ns % kNsPerSecond);
}

void RequireFewer(std::size_t num_images, std::size_t most) {
  if (num_images <= most) return;
  // No std::invalid_argument, which is one damaged record.
  throw TooManyImages(fmt::format("it has more than {} images: split it", most));
}

void Note(const BagMessage& message, const NamedBagFile& bag, Decompressor& decompressor,
          Index* index) {
  const bool compressed = message.type == kCompressed;
  const bool is_image = compressed || message.type == kImage;
  if (message.encoding != "cdr" || (!is_image && message.type != kInfo)) return;
  const std::string topic(message.topic);
  if (!is_image) {
    index->infos.try_emplace(topic, message.data.substr(0, kLargestHead));
    return;
  }
  std::vector<TimedImage>& images = index->images[topic];
  const std::string image = fmt::format("image {} of {}", images.size() + 1, topic);
  try {
    const Header header = HeaderOf(decompressor.Head(message.data, kLargestHead));
    const std::int64_t time = TimeOf(header, message);
    index->frames.try_emplace(topic, header.frame.substr(0, kLongestName));
    const std::string path = bag.name + ": " + image;
    index->places[path] = {bag.file, message.place, compressed};
    images.push_back({time, Seconds(time), path});
  } catch (const std::invalid_argument& error) {
    BrokenImages& broken = index->broken[topic];
    if (broken.number++ == 0) broken.first = image + ": " + error.what();
  }
}

std::vector<std::string> TopicsOf(const Index& index) {
  std::vector<std::string> topics;
  for (const auto& [topic, images] : index.images) topics.push_back(topic);
  return topics;
}

// What is wrong with the bag, for people.
std::vector<std::string> NoteAll(const std::vector<NamedBagFile>& files, std::size_t most_images,
                                 Index* index) {
  std::vector<std::string> faults;
  Decompressor decompressor;
  for (const NamedBagFile& bag : files) {
    const auto note = [&](const BagMessage& message) {
      Note(message, bag, decompressor, index);
      RequireFewer(index->places.size(), most_images);
    };
    try {
      for (const std::string& fault : bag.file->ForEachMessage(note)) {
        faults.push_back(bag.name + " " + fault);
      }
    } catch (const std::invalid_argument& error) {
      if (files.size() == 1) throw;
      faults.push_back(bag.name + " cannot be read (" + error.what() + ")");
    }
  }
  return faults;
}

void RequireFrames(const Bag& bag, const std::vector<std::string>& faults) {
  if (!bag.list.frames.empty()) return;
  std::vector<std::string> why = bag.list.notes;
  why.insert(why.end(), faults.begin(), faults.end());
  throw std::invalid_argument(fmt::format("it has no frames; {}", fmt::join(why, "; ")));
}

void NoteBroken(const Index& index, Bag* bag) {
  for (const std::string& topic : {bag->color_topic, bag->depth_topic}) {
    const auto broken = index.broken.find(topic);
    if (broken == index.broken.end()) continue;
    bag->list.notes.push_back(fmt::format("broken images are left out: {}, the first is {}",
                                          broken->second.number, broken->second.first));
  }
}

}  // namespace

Bag ReadBag(const std::vector<NamedBagFile>& files, const BagFlags& flags) {
  Index index;
  const std::vector<std::string> faults = NoteAll(files, flags.most_images, &index);
  const std::vector<std::string> all = TopicsOf(index);
  if (all.empty()) {
    std::string why = "it has no images of ROS 2";
    for (const std::string& fault : faults) why += "; " + fault;
    throw std::invalid_argument(why);
  }
  Bag bag;
  bag.color_topic = ColorTopic(all, flags.color_topic);
  bag.depth_topic = DepthTopic(all, flags.depth_topic);
  bag.list = PairByTime(index.images.at(bag.color_topic), index.images.at(bag.depth_topic));
  bag.color_frame = index.frames[bag.color_topic];
  bag.depth_frame = index.frames[bag.depth_topic];
  NoteBroken(index, &bag);
  RequireFrames(bag, faults);
  for (const std::string& fault : faults) {
    bag.list.notes.push_back(fault + "; what else it has is read");
  }
  for (FrameFiles& frame : bag.list.frames) {
    frame.read_color = [image = index.places.at(frame.color_path)] {
      return ColorFile(image.Data(), image.is_compressed);
    };
    frame.read_depth = [image = index.places.at(frame.depth_path), unit_m = flags.depth_unit_m] {
      return DepthFile(image.Data(), image.is_compressed, unit_m);
    };
  }
  std::vector<std::string> infos;
  for (const auto& [topic, message] : index.infos) infos.push_back(topic);
  bag.info_topic = InfoTopic(infos, bag.color_topic);
  if (!bag.info_topic.empty()) bag.camera_info = index.infos[bag.info_topic];
  return bag;
}

std::string NoteOfUnregistered(const Bag& bag) {
  if (bag.color_frame.empty() || bag.depth_frame.empty()) return {};
  if (bag.color_frame == bag.depth_frame) return {};
  return fmt::format(
      "depth is of the frame {}, colour of {}: unless it is registered to colour all the same, "
      "masks and positions are wrong without --depth-intrinsics and --color-from-depth",
      bag.depth_frame, bag.color_frame);
}

std::optional<Calibration> ColorCameraOf(const Bag& bag) {
  if (bag.camera_info.empty()) return std::nullopt;
  try {
    return CameraInfo(Unpacked(bag.camera_info), IsRectified(bag.color_topic));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(bag.info_topic + ": " + error.what() +
                                "; give --intrinsics instead");
  }
}

}  // namespace fovea::cli
