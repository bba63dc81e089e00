// What is set once for a process that detects, apart from the service, so that benchmarks run
// alike.
#pragma once

namespace fovea::server {

// Memory, threads and tables for `num_threads` detections side by side. Before any thread starts.
// Takes some 60 ms.
void SetUpComputing(int num_threads);

}  // namespace fovea::server
