#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace fovea::bundle {

// What a zip file may hold; what says that it holds more is refused before anything is unpacked.
struct ZipLimits {
  std::size_t max_entries = 4096;
  std::uint64_t max_entry_bytes = std::uint64_t{64} << 20;   // unpacked
  std::uint64_t max_total_bytes = std::uint64_t{512} << 20;  // of all, unpacked
};

// A zip file in memory. Thread-safe. Names with folders, with anything but letters, digits, '.',
// '_' and '-', or that stand there twice, are refused: nothing is ever written by them elsewhere.
class ZipReader {
 public:
  // Throws std::invalid_argument that says what is wrong.
  explicit ZipReader(std::string bytes, const ZipLimits& limits = {});
  ~ZipReader();

  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  bool Has(const std::string& name) const;

  // Throws std::invalid_argument where there is no such entry, or it is damaged.
  std::string Read(const std::string& name) const;

 private:
  struct Close;

  const std::string bytes_;
  const ZipLimits limits_;
  mutable std::mutex mutex_;
  std::unique_ptr<void, void (*)(void*)> zip_;
  std::vector<std::string> names_;
};

}  // namespace fovea::bundle
