// How much a process holds: what grows without end leaks.
#pragma once

#include <cstddef>
#include <string>

namespace fovea::load {

struct ProcessSize {
  std::size_t resident_mb = 0, threads = 0, files = 0;

  std::string Text() const;
};

// Of a process on this machine that one may look at. Throws std::runtime_error where there is none.
ProcessSize SizeOfProcess(int pid);

}  // namespace fovea::load
