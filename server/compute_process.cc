#include "server/compute_process.h"

#include <malloc.h>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/utility.hpp>

#include "core/types/lab.h"

namespace fovea::server {

// Every frame allocates and frees the same large images: keeping them spares the page faults, and
// detections run side by side, so each is worth one thread. Each of malloc's arenas keeps the most
// that it ever held, mostly at its end, which only the first gives back (SpareMemory); glibc makes
// eight for each processor, over which threads and with them such peaks wander for hours. A
// detection allocates some 800 times, so that a few threads can share one.
void SetUpComputing(int num_threads) {
  constexpr int kThreadsPerArena = 8;
  mallopt(M_ARENA_MAX, 1 + (num_threads - 1) / kThreadsPerArena);
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  cv::setNumThreads(1);
  // OpenCV makes its tables of colours with the first one, for which the first frame would wait.
  LabOf(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(0)));
}

}  // namespace fovea::server
