// The server's executable where not all of its threads can be started.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/e2e/process.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

// So large that a thread is what finds no memory.
constexpr long kStackKib = 128L << 10;

// With so much memory for all of it.
std::vector<std::string> LimitedServer(const std::string& memory_kib, int compute_threads) {
  const std::string limit = "ulimit -s " + std::to_string(kStackKib) + "; ulimit -v " + memory_kib +
                            "; exec \"$0\" \"$@\"";
  return {"sh",
          "-c",
          limit,
          FOVEA_SERVER,
          "--listen",
          "127.0.0.1:0",
          "--self-check-s",
          "0",
          "--compute-threads",
          std::to_string(compute_threads)};
}

// What a server with one compute thread has when all of its threads have started.
long MemoryKib() {
  Process server(LimitedServer("unlimited", 1));
  server.ReadLine();
  std::ifstream status("/proc/" + std::to_string(server.pid()) + "/status");
  std::string word;
  while (status >> word && word != "VmSize:") continue;
  long kib = 0;
  status >> kib;
  return kib;
}

TEST(FewThreads, EndTheServerThatStarts) {
  constexpr int kMany = 200;           // more than all others are
  for (const int more : {0, kMany}) {  // not enough for all that compute, for all that help them
    const std::string memory = std::to_string(MemoryKib() + more * kStackKib);
    const Finished finished = Execute(LimitedServer(memory, kMany));
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_THAT(finished.err, HasSubstr("no thread can be started"));
  }
}

}  // namespace
}  // namespace fovea::testing
