#include "client/cli/bag/mcap_bytes.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "client/cli/bag/byte_reader.h"

namespace fovea::cli {
namespace {

class SharedFile {
 public:
  explicit SharedFile(const std::string& path) : stream_(path, std::ios::binary) {
    if (!stream_) throw std::invalid_argument("it cannot be read");
  }

  std::string Part(std::uint64_t start, std::uint64_t size) {
    std::string bytes(size, '\0');
    const std::lock_guard lock(mutex_);
    Seek(start);
    stream_.read(bytes.data(), static_cast<std::streamsize>(size));
    if (stream_) {
      next_ = start + size;
      return bytes;
    }
    throw std::invalid_argument(stream_.bad() ? "it cannot be read there"
                                              : "it was shortened while it was read");
  }

 private:
  // Which drops what the stream has read ahead: many small records, most often.
  void Seek(std::uint64_t start) {
    if (stream_ && next_ == start) return;
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(start));
  }

  std::mutex mutex_;
  std::ifstream stream_;
  std::uint64_t next_ = 0;
};

}  // namespace

McapBytes McapInMemory(std::string_view bytes) {
  return {bytes.size(), [bytes](std::uint64_t start, std::uint64_t size) {
            ByteReader reader(bytes);
            reader.Bytes(start);
            return std::string(reader.Bytes(size));
          }};
}

// Not mapped: what is cut off, or cannot be read, would end the program.
McapBytes McapInFile(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) throw std::invalid_argument("there is no such file");
  const auto file = std::make_shared<SharedFile>(path);
  return {std::filesystem::file_size(path),
          [file](std::uint64_t start, std::uint64_t size) { return file->Part(start, size); }};
}

}  // namespace fovea::cli
