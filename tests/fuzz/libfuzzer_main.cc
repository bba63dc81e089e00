// The target that libFuzzer runs is told by the name of the program, as its flags are its own:
// rvl_fuzzer is a link to fovea-fuzzer.
#include <google/protobuf/stubs/logging.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "tests/fuzz/fuzz_targets.h"

namespace {

fovea::fuzzing::Target target = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** argv) {
  constexpr std::string_view kEnd = "_fuzzer";
  std::string name = std::filesystem::path(**argv).filename();
  if (name.ends_with(kEnd))
    target = fovea::fuzzing::TargetOf(name.erase(name.size() - kEnd.size()));
  if (target == nullptr) {
    std::cerr << name << ": must be called by a link that is named TARGET_fuzzer\n";
    std::exit(2);
  }
  google::protobuf::SetLogHandler(
      nullptr);  // else it writes a line for each name that is not UTF-8
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target(data, size);
  return 0;
}
