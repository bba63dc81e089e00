#include "client/observer/history/history_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/sha.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace fovea::observer {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& folder, int error) {
  throw std::system_error(error, std::generic_category(), "--history: " + folder.string());
}

// Begins with a dot, which no name has otherwise.
std::string HashOf(const std::string& text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), hash.data());
  std::string digits = ".";
  for (const unsigned char byte : hash) digits += fmt::format("{:02x}", byte);
  return digits;
}

}  // namespace

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  fs::create_directories(folder.parent_path(), error);
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) Fail(folder, errno);
}

std::string FolderNameOf(const std::string& robot) {
  constexpr std::size_t kMost = 200;  // file systems end at 255; certificates name robots at length
  std::string name;
  for (const char c : robot) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  if (name.size() <= kMost) return name;
  const std::string hash = HashOf(robot);
  return name.substr(0, kMost - hash.size()) + hash;
}

// No robot's folder has that name.
FolderLock::FolderLock(const fs::path& folder) : path_(folder / ".lock") {
  MakeFolder(folder);
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file_ < 0) Fail(path_, errno);
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw std::runtime_error("--history: " + folder.string() + ": another program uses it");
}

FolderLock::~FolderLock() { close(file_); }

bool FolderLock::IsInPlace() const {
  struct stat held {
  }, there{};
  return fstat(file_, &held) == 0 && stat(path_.c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

}  // namespace fovea::observer
