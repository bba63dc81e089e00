// MCAP (mcap.dev/spec), the files of ROS 2 bags, as far as messages need it: no indices, so that a
// bag whose recorder was killed is read, too.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fovea::cli {

// Bytes that are read part by part, by several threads at once.
struct McapBytes {
  std::uint64_t size = 0;
  // Throws std::invalid_argument where they are not there, or not any more.
  std::function<std::string(std::uint64_t start, std::uint64_t size)> part = {};
};

// Of `bytes`, which live as long as what is returned.
McapBytes McapInMemory(std::string_view bytes);
// Of a file that others may shorten meanwhile. Throws std::invalid_argument where it is none.
McapBytes McapInFile(const std::string& path);

// Where a message lies in a file.
struct McapPlace {
  std::uint64_t chunk = 0;  // content of the chunk's record, or 0 = the message is in none
  std::uint64_t chunk_bytes = 0;
  std::uint64_t start = 0, size = 0;  // of its data, in the chunk's records or in the file
};

struct McapMessage {
  std::string_view topic, type, encoding;  // "/camera/image_raw", "sensor_msgs/msg/Image", "cdr"
  std::int64_t log_time_ns = 0;
  std::string_view data;
  McapPlace place;
};

// What of a file could not be read.
struct McapFaults {
  std::optional<std::uint64_t> end;  // where it breaks off, as there is no whole record
  std::uint64_t num_damaged = 0;     // records that contradict themselves or their checksum
  std::string first_damage = {};     // "at byte 33: a chunk holds less than it says"
};

// Calls `use` with each message of a record that is whole, in their order in the file. Throws
// std::invalid_argument where it is no MCAP.
McapFaults ForEachMessage(const McapBytes& file,
                          const std::function<void(const McapMessage&)>& use);

// The data of a message that ForEachMessage found there.
std::string DataAt(const McapBytes& file, const McapPlace& place);

}  // namespace fovea::cli
