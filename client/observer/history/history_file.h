// One recorded frame as a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "fovea/v1/observation_service.pb.h"

namespace fovea::observer {

// What lists need of a file, at its beginning.
struct HistoryHeader {
  std::string robot = {};
  std::string server = {};   // address, as it was given
  std::string version = {};  // of that server
  std::uint32_t objects = 0;
  bool problem = false;
};

struct HistoryRecord {
  HistoryHeader header = {};
  v1::WatchedFrame frame = {};
};

// Of the file that would be written, in bytes.
std::uint64_t HistoryFileSize(const HistoryRecord& record);

// Writes a file that is there as a whole or not at all, whatever ends this program. `path` must not
// exist. Throws std::system_error that names it.
void WriteHistoryFile(const std::filesystem::path& path, const HistoryRecord& record);

// None where the file is not whole, is none of these, or cannot be read. The header alone is read
// without the rest; a damaged rest shows when all is read.
std::optional<HistoryHeader> ReadHistoryHeader(const std::filesystem::path& path);
std::optional<HistoryRecord> ReadHistoryFile(const std::filesystem::path& path);

}  // namespace fovea::observer
