#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace fovea::capture {

// Counts the images in a recording of OpenNI2, also while it grows: it is a chain of records, each
// of which says how long it is.
class RecordingFile {
 public:
  explicit RecordingFile(std::string path);

  // Reads on from where it was. Returns how many images the stream with the fewest has; 0 until
  // `num_streams` streams have some.
  std::uint64_t CountFrames(std::size_t num_streams);

 private:
  const std::string path_;
  std::uint64_t position_;
  std::map<std::uint32_t, std::uint64_t> num_images_;  // by stream
};

// Whether the file starts as recordings do, and whether a record follows.
bool IsRecordingFile(const std::string& path);
bool HasRecords(const std::string& path);

}  // namespace fovea::capture
