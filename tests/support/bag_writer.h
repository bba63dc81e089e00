// Makes small ROS 2 bags (MCAP), as rosbag2 writes them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fovea::testing {

// A message of sensor_msgs in CDR; `stamp_ns` and `frame` in its header.
std::string ImageMessage(std::int64_t stamp_ns, std::string_view encoding, std::uint32_t width,
                         std::uint32_t height, std::uint32_t step, std::string_view data,
                         std::string_view frame = "camera");
std::string CompressedMessage(std::int64_t stamp_ns, std::string_view format,
                              std::string_view data);
// As in sensor_msgs; all 0 = whole images.
struct Window {
  std::uint32_t binning_x = 0, binning_y = 0, x_offset = 0, y_offset = 0, height = 0, width = 0;
};
// fx = fy = `focal_px`, plumb_bob with k1 = `k1`.
std::string CameraInfoMessage(std::uint32_t width, std::uint32_t height, double focal_px,
                              double k1 = 0, const Window& window = {});

class BagWriter {
 public:
  BagWriter();

  // `type`: "Image" of sensor_msgs/msg. Each message brings a channel of its own, which readers
  // have to take as well.
  void Add(std::string_view topic, std::string_view type, std::string_view message);
  // A chunk of what was added since the last one; "zstd", "lz4" or "".
  void EndChunk(std::string_view compression, bool with_checksum = false);

  // The bag; what is in no chunk comes last.
  std::string Finish();

 private:
  std::string file_, open_;
  std::uint16_t next_id_ = 1;
};

}  // namespace fovea::testing
