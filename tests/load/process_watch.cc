#include "tests/load/process_watch.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fovea::load {

std::string ProcessSize::Text() const {
  return fmt::format("{} MB, {} threads, {} open files", resident_mb, threads, files);
}

ProcessSize SizeOfProcess(int pid) {
  const std::filesystem::path folder = fmt::format("/proc/{}", pid);
  std::ifstream status(folder / "status");
  if (!status) throw std::runtime_error(fmt::format("--pid: there is no process {}", pid));
  ProcessSize size;
  for (std::string key; status >> key; status.ignore(1000, '\n')) {
    if (key == "VmRSS:") {
      status >> size.resident_mb;  // in kB
      size.resident_mb /= 1024;
    } else if (key == "Threads:") {
      status >> size.threads;
    }
  }
  const std::filesystem::directory_iterator files(folder / "fd");
  size.files = static_cast<std::size_t>(std::distance(begin(files), end(files)));
  return size;
}

}  // namespace fovea::load
