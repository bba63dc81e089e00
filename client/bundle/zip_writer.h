#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fovea::bundle {

// Makes a zip file in memory.
class ZipWriter {
 public:
  // `time` is in seconds since 1970, of all entries: the same entries make the same file.
  explicit ZipWriter(std::int64_t time) : time_(time) {}

  // `is_packed`: its bytes cannot be made fewer (JPEG, PNG).
  void Add(std::string name, std::string bytes, bool is_packed = false);

  // Throws std::runtime_error.
  std::string Finish() const;

 private:
  struct Entry {
    std::string name, bytes;
    bool is_packed = false;
  };

  const std::int64_t time_;
  std::vector<Entry> entries_;
};

}  // namespace fovea::bundle
