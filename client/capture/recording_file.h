#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace fovea::capture {

// Counts the streams and images in a recording of OpenNI2, also while it grows: it is a chain of
// records, each of which says how long it is.
class RecordingFile {
 public:
  explicit RecordingFile(std::string path);

  // Both read on from where the last one was. How many images the stream with the fewest has;
  // 0 until `num_streams` streams have some.
  std::uint64_t CountFrames(std::size_t num_streams);
  // How many streams there are whose images are kept from now on.
  std::size_t CountStreams();

 private:
  void ReadOn();

  const std::string path_;
  std::uint64_t position_;
  std::size_t num_streams_ = 0;
  std::map<std::uint32_t, std::uint64_t> num_images_;  // by stream
};

// Whether the file starts as recordings do, and whether a record follows.
bool IsRecordingFile(const std::string& path);
bool HasRecords(const std::string& path);

// Throws std::runtime_error where less than this is free on the disk of the file, or it would be
// larger than files may be there.
void RequireRoom(const std::string& path, std::uintmax_t bytes);

}  // namespace fovea::capture
