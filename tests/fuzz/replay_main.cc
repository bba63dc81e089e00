// Runs a target over the files of its corpus, with any compiler and sanitizer.
// usage: fovea-fuzz-replay TARGET FOLDER
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "tests/fuzz/fuzz_targets.h"

int main(int argc, char** argv) {
  const fovea::fuzzing::Target target = argc == 3 ? fovea::fuzzing::TargetOf(argv[1]) : nullptr;
  if (target == nullptr) {
    std::cerr << "usage: fovea-fuzz-replay TARGET FOLDER\n";
    return 2;
  }
  int num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[2])) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++num_files;
  }
  std::cout << num_files << " inputs\n";
  return num_files == 0;  // an empty corpus tests nothing
}
