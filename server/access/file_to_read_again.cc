#include "server/access/file_to_read_again.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "server/conversion/field_error.h"

namespace fovea::server {

void RequireFileToReadAgain(const std::string& flag, const std::string& path) {
  using std::filesystem::file_type;
  std::error_code error;
  const file_type type = std::filesystem::status(path, error).type();
  const bool is_none = std::filesystem::weakly_canonical(path, error) == "/dev/null";
  RequireField(type != file_type::fifo && (type != file_type::character || is_none), flag,
               path + " is no file that can be read again");
  if (type != file_type::regular) return;
  constexpr std::uintmax_t kLargest = std::uintmax_t{16} << 20;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  RequireField(error || size <= kLargest, flag, path + " has more than 16 MiB");
}

void RequireReadable(const std::string& flag, const std::string& path) {
  RequireFileToReadAgain(flag, path);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (file.is_open()) file.peek();  // a folder can be opened
  RequireField(file.is_open() && !file.bad(), flag,
               "cannot read " + path + ": " + std::strerror(errno));
}

}  // namespace fovea::server
