#include "server/access/published_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace fovea::server {
namespace {

void Require(bool holds) {
  if (!holds) throw std::runtime_error(std::string("a file in memory: ") + std::strerror(errno));
}

FileDescriptor MakeFile(const std::string& text, long version) {
  FileDescriptor file(memfd_create("fovea", MFD_CLOEXEC));
  Require(static_cast<bool>(file));
  Require(fchmod(file.get(), S_IRUSR | S_IWUSR) == 0);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t size = write(file.get(), text.data() + done, text.size() - done);
    Require(size > 0);
    done += static_cast<std::size_t>(size);
  }
  const timespec time{.tv_sec = version, .tv_nsec = 0};
  Require(futimens(file.get(), std::array{time, time}.data()) == 0);
  return file;
}

}  // namespace

PublishedFile::PublishedFile(const std::string& text) : descriptor_(MakeFile(text, version_)) {}

std::string PublishedFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_.get());
}

void PublishedFile::Replace(const std::string& text) {
  const FileDescriptor file = MakeFile(text, version_ + 1);
  Require(dup3(file.get(), descriptor_.get(), O_CLOEXEC) >= 0);
  ++version_;
}

}  // namespace fovea::server
