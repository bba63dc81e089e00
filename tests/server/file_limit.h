// How many files a process may have open, and has.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <filesystem>
#include <iterator>

namespace fovea::testing {

// Holds as long as this lives, for files that are opened meanwhile.
class FileLimit {
 public:
  explicit FileLimit(rlim_t number) {
    getrlimit(RLIMIT_NOFILE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = number;
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  ~FileLimit() { setrlimit(RLIMIT_NOFILE, &before_); }

  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  rlimit before_{};
};

inline std::size_t NumOpenFiles() {
  const std::filesystem::directory_iterator files("/proc/self/fd"), end;
  return static_cast<std::size_t>(std::distance(files, end));
}

}  // namespace fovea::testing
