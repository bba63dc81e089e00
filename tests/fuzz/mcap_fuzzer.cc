#include "client/cli/bag/bag.h"
#include "client/cli/bag/mcap.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Try([&] {
    const auto file = cli::McapFile(cli::McapInMemory(fuzzing::Text(data, size)));
    const cli::Bag bag = cli::ReadBag({{"bag", file}}, {});
    for (const cli::FrameFiles& frame : bag.list.frames) {
      fuzzing::Try([&] { frame.read_color(); });
      fuzzing::Try([&] { frame.read_depth(); });
    }
  });
  return 0;
}
