#include <benchmark/benchmark.h>

#include "server/compute_process.h"

int main(int argc, char** argv) {
  fovea::server::SetUpComputing(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
