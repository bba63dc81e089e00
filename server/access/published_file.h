#pragma once

#include <string>

#include "server/connections/file_descriptor.h"

namespace fovea::server {

// A file that only this process writes, and that whoever opens its path reads as a whole: it lives
// in memory and needs no folder. For libraries that watch files and cannot be told of changes.
class PublishedFile {
 public:
  // Throws std::runtime_error where the system has no room for it.
  explicit PublishedFile(const std::string& text);

  // Good as long as this lives.
  std::string path() const;

  // At once: who has it open reads on what was. Each text has another modification time, in whole
  // seconds, so that who opens the path twice can tell. Throws like the constructor, and changes
  // nothing then.
  void Replace(const std::string& text);

 private:
  long version_ = 1;
  FileDescriptor descriptor_;
};

}  // namespace fovea::server
