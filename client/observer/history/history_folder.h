// Where a history lies on disk.
#pragma once

#include <filesystem>
#include <string>

namespace fovea::observer {

// For its user alone, with what leads there, where it is missing. Throws std::system_error.
void MakeFolder(const std::filesystem::path& folder);

// A name that is a folder's and no other robot's: "kitchen/1" is "kitchen%2F1"; what would be too
// long ends with a hash of all of it.
std::string FolderNameOf(const std::string& robot);

// Makes a folder one program's, as two would drop each other's frames.
class FolderLock {
 public:
  // Makes the folder where it is missing. Throws std::runtime_error where it cannot be used, or
  // another program does.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();

  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // False where the folder was moved away, whether or not another one is there.
  bool IsInPlace() const;

 private:
  const std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace fovea::observer
