#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace fovea::testing {

// A folder of its own, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fovea_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string Path() const { return path_.string(); }
  std::string At(const std::string& name) const { return (path_ / name).string(); }

  // Replaces the whole file at once. Returns its path.
  std::string Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(At(name + ".new"), std::ios::binary) << bytes;
    std::filesystem::rename(At(name + ".new"), At(name));
    return At(name);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace fovea::testing
