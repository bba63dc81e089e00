#include "server/access/token_file.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "server/byte_order_mark.h"

namespace fovea::server {
namespace {

// A pipe would be waited for, and cannot be read again; devices need not end.
void RequireFile(const std::string& flag, const std::string& path) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  const bool is_none = std::filesystem::weakly_canonical(path, error) == "/dev/null";
  if (type == std::filesystem::file_type::fifo ||
      (type == std::filesystem::file_type::character && !is_none)) {
    throw std::runtime_error(flag + ": " + path + " is no file that can be read again");
  }
}

}  // namespace

void ForEachTokenLine(const std::string& flag, const std::string& path,
                      const std::function<void(const std::string&)>& add) {
  RequireFile(flag, path);
  std::ifstream file(path);
  if (!file) throw std::runtime_error(flag + ": cannot read " + path);
  const std::string in = flag + ": " + path + ":";
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    if (number == 0 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    InField(in + std::to_string(++number), [&] { add(line); });
  }
  if (file.bad()) throw std::runtime_error(flag + ": cannot read " + path);  // a folder
}

}  // namespace fovea::server
