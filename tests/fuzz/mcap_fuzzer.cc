#include "client/cli/bag/bag.h"
#include "client/cli/bag/mcap.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::fuzzing {

void FuzzMcap(const std::uint8_t* data, std::size_t size) {
  Try([&] {
    const auto file = cli::McapFile(cli::McapInMemory(Text(data, size)));
    const cli::Bag bag = cli::ReadBag({{"bag", file}}, {});
    for (const cli::FrameFiles& frame : bag.list.frames) {
      Try([&] { frame.read_color(); });
      Try([&] { frame.read_depth(); });
    }
  });
}

}  // namespace fovea::fuzzing
