// A file of messages that ROS 2 recorded, whatever its format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fovea::cli {

// Where a message lies in its file; what the numbers mean is the format's matter.
struct MessagePlace {
  std::uint64_t chunk = 0;
  std::uint64_t chunk_bytes = 0;
  std::uint64_t start = 0, size = 0;
};

struct BagMessage {
  std::string_view topic, type, encoding;  // "/camera/image_raw", "sensor_msgs/msg/Image", "cdr"
  std::int64_t log_time_ns = 0;
  std::string_view data;
  MessagePlace place;
};

// Of topics, as DDS has it; what is longer is damage, or an attempt to take all memory.
inline constexpr std::size_t kLongestName = 256;

class BagFile {
 public:
  virtual ~BagFile() = default;

  // Calls `use` with each message that can be read, in their order in the file. Returns what of it
  // cannot: "breaks off at byte 3 of 9". Throws std::invalid_argument where it is no such file.
  virtual std::vector<std::string> ForEachMessage(
      const std::function<void(const BagMessage&)>& use) const = 0;

  // The data of a message that was found there; by several threads at once. Throws
  // std::invalid_argument where it is not there any more.
  virtual std::string DataAt(const MessagePlace& place) const = 0;
};

}  // namespace fovea::cli
