#include "server/logging/line_writer.h"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace fovea::server {
namespace {

bool IsA(int fd, mode_t type) {
  struct stat status {};
  return fstat(fd, &status) == 0 && (status.st_mode & S_IFMT) == type;
}

// The same pipe or terminal, but without waiting: that is a property of each opening, which others
// share when they inherit it. None where it is nothing that one waits for, or may not be opened.
FileDescriptor OpenAnew(int fd) {
  if (!IsA(fd, S_IFIFO) && !IsA(fd, S_IFCHR)) return FileDescriptor();
  const std::string path = "/proc/self/fd/" + std::to_string(fd);
  return FileDescriptor(open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
}

}  // namespace

LineWriter::LineWriter(int fd)
    : own_(OpenAnew(fd)),
      fd_(own_ ? own_.get() : fd),
      is_stream_(IsA(fd, S_IFIFO) || IsA(fd, S_IFCHR) || IsA(fd, S_IFREG) || IsA(fd, S_IFSOCK)),
      is_socket_(IsA(fd, S_IFSOCK)) {}

bool LineWriter::Write(std::string_view line) {
  if (in_line_) {
    if (WriteSome("\n") == 0) return false;
    in_line_ = false;
  }
  while (!line.empty()) {
    const std::size_t written = WriteSome(line.substr(0, PIPE_BUF));
    if (written == 0) return false;
    line.remove_prefix(written);
    in_line_ = !line.empty();
  }
  return true;
}

// A pipe that poll calls writable takes PIPE_BUF bytes without waiting.
std::size_t LineWriter::WriteSome(std::string_view text) const {
  if (!is_stream_) return 0;
  ssize_t size = 0;
  if (is_socket_) {
    size = send(fd_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  } else {
    pollfd ready{.fd = fd_, .events = POLLOUT, .revents = 0};
    if (poll(&ready, 1, /*timeout=*/0) != 1 || (ready.revents & POLLOUT) == 0) return 0;
    size = write(fd_, text.data(), text.size());
  }
  return static_cast<std::size_t>(std::max<ssize_t>(size, 0));
}

}  // namespace fovea::server
