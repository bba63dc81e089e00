#include "server/access/token_file.h"

#include <fstream>
#include <stdexcept>

#include "server/access/file_to_read_again.h"
#include "server/byte_order_mark.h"
#include "server/logging/log_record.h"

namespace fovea::server {

void RequireTokenName(const std::string& what, const std::string& name) {
  constexpr std::size_t kMost = 64;
  RequireField(name.size() <= kMost, what, "has more than 64 characters");
  RequireField(IsUtf8(name), what, "is no UTF-8");
}

void ForEachTokenLine(const std::string& flag, const std::string& path,
                      const std::function<void(const std::string&)>& add) {
  RequireReadable(flag, path);
  std::ifstream file(path);
  const std::string in = flag + ": " + path + ":";
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    if (number == 0 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    InField(in + std::to_string(++number), [&] { add(line); });
  }
  if (!file.eof()) throw std::runtime_error(flag + ": cannot read " + path);  // changed meanwhile
}

}  // namespace fovea::server
