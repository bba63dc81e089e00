#include "server/access/file_to_read_again.h"

#include <filesystem>
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
}

}  // namespace fovea::server
