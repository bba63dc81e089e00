#pragma once

#include <cstddef>
#include <string_view>

#include "server/connections/file_descriptor.h"

namespace fovea::server {

// Writes lines to a file, terminal, pipe or socket and never waits for who reads them: what does
// not fit at once is dropped. Not thread-safe.
class LineWriter {
 public:
  // `fd` stays the caller's, and as it is: others may share it. What is none of these, as an
  // eventfd that a library opened in place of a closed stderr, is left alone.
  explicit LineWriter(int fd);

  // `line` ends with a newline. Whether it was written; where it was in part, the next one begins a
  // line of its own.
  bool Write(std::string_view line);

 private:
  // Writes what fits of it at once; how much.
  std::size_t WriteSome(std::string_view text) const;

  const FileDescriptor own_;  // where it can be opened anew: so that it need not wait
  const int fd_;
  const bool is_stream_, is_socket_;
  bool in_line_ = false;  // the last one was written in part
};

}  // namespace fovea::server
