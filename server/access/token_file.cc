#include "server/access/token_file.h"

#include <fstream>
#include <stdexcept>

namespace fovea::server {

void ForEachTokenLine(const std::string& flag, const std::string& path,
                      const std::function<void(const std::string&)>& add) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(flag + ": cannot read " + path);
  const std::string in = flag + ": " + path + ":";
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    InField(in + std::to_string(++number), [&] { add(line); });
  }
  if (file.bad()) throw std::runtime_error(flag + ": cannot read " + path);  // a folder
}

}  // namespace fovea::server
