#include "client/capture/recording_file.h"

#include <linux/magic.h>
#include <sys/resource.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace fovea::capture {
namespace {

constexpr std::string_view kFileMagic = "NI10";
constexpr std::string_view kRecordMagic("NIR\0", 4);
constexpr std::uint64_t kFirstRecord = 24;
// Kinds of records: from here on there are images of a stream; one of them.
constexpr std::uint32_t kStreamBegins = 8, kImage = 10;

// How each record starts; little-endian, like all machines that this is built for.
struct RecordHeader {
  std::array<char, 4> magic;
  std::uint32_t kind, stream, header_bytes, payload_bytes;
};
static_assert(sizeof(RecordHeader) == 20);

bool HasText(const std::string& path, std::uint64_t position, std::string_view text) {
  std::ifstream file(path, std::ios::binary);
  std::string found(text.size(), '\0');
  file.seekg(static_cast<std::streamoff>(position));
  file.read(found.data(), static_cast<std::streamsize>(found.size()));
  return file && found == text;
}

std::uintmax_t LargestFileIn(const std::filesystem::path& folder) {
  constexpr std::uintmax_t kOfFat = 0xFFFF'FFFF;
  rlimit of_process{};
  getrlimit(RLIMIT_FSIZE, &of_process);
  struct statfs system {};
  const bool is_fat = statfs(folder.c_str(), &system) == 0 && system.f_type == MSDOS_SUPER_MAGIC;
  return is_fat ? std::min<std::uintmax_t>(of_process.rlim_cur, kOfFat) : of_process.rlim_cur;
}

}  // namespace

RecordingFile::RecordingFile(std::string path) : path_(std::move(path)), position_(kFirstRecord) {}

void RecordingFile::ReadOn() {
  std::ifstream file(path_, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
  RecordHeader header{};
  while (position_ + sizeof header <= size) {
    file.seekg(static_cast<std::streamoff>(position_));
    file.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!file || std::string_view(header.magic.data(), header.magic.size()) != kRecordMagic) break;
    const std::uint64_t end = position_ + header.header_bytes + header.payload_bytes;
    if (end <= position_ || end > size) break;  // not written to its end yet
    if (header.kind == kStreamBegins) ++num_streams_;
    if (header.kind == kImage) ++num_images_[header.stream];
    position_ = end;
  }
}

std::size_t RecordingFile::CountStreams() {
  ReadOn();
  return num_streams_;
}

std::uint64_t RecordingFile::CountFrames(std::size_t num_streams) {
  ReadOn();
  if (num_images_.size() < num_streams) return 0;
  return std::min_element(num_images_.begin(), num_images_.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->second;
}

bool IsRecordingFile(const std::string& path) { return HasText(path, 0, kFileMagic); }
bool HasRecords(const std::string& path) { return HasText(path, kFirstRecord, kRecordMagic); }

void RequireRoom(const std::string& path, std::uintmax_t bytes) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (std::filesystem::space(folder).available < bytes) {
    throw std::runtime_error("cannot record any more to " + path + ": no space left on the disk");
  }
  std::error_code none_yet;
  const std::uintmax_t size = std::filesystem::file_size(path, none_yet);
  if (none_yet || size + bytes <= LargestFileIn(folder)) return;
  throw std::runtime_error("cannot record any more to " + path +
                           ": its file system (FAT), or ulimit -f, has no larger files");
}

}  // namespace fovea::capture
