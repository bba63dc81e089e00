#include "server/spare_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

namespace fovea::testing {
namespace {

// In bytes.
std::size_t ResidentMemory() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(getpagesize());
}

TEST(SpareMemory, GoesBackToTheSystem) {
  constexpr std::size_t kBlock = 100'000, kNumBlocks = 640;
  std::vector<std::unique_ptr<char[]>> blocks(kNumBlocks);
  for (auto& block : blocks) block = std::make_unique<char[]>(kBlock);
  // What is still used behind them keeps malloc from giving them back by itself.
  const auto behind = std::make_unique<char[]>(kBlock);
  blocks.clear();
  const std::size_t before = ResidentMemory();
  const server::SpareMemory spare(std::chrono::milliseconds(1));
  while (ResidentMemory() + kNumBlocks * kBlock / 2 > before) std::this_thread::yield();
}

}  // namespace
}  // namespace fovea::testing
