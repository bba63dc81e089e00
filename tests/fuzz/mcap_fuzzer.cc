#include <stdexcept>

#include "client/cli/bag/bag.h"
#include "client/cli/bag/mcap.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::fuzzing {
namespace {

// More images than are kept are refused otherwise than what is damaged.
cli::Bag BagIn(const std::uint8_t* data, std::size_t size) {
  const auto file = cli::McapFile(cli::McapInMemory(Text(data, size)));
  try {
    return cli::ReadBag({{"bag", file}}, {});
  } catch (const cli::TooManyImages& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

void FuzzMcap(const std::uint8_t* data, std::size_t size) {
  Try([&] {
    const cli::Bag bag = BagIn(data, size);
    for (const cli::FrameFiles& frame : bag.list.frames) {
      Try([&] { frame.read_color(); });
      Try([&] { frame.read_depth(); });
    }
  });
}

}  // namespace fovea::fuzzing
