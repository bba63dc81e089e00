#include "tests/evaluation/real_frames/boxed_run.h"

#include <chrono>
#include <mutex>

#include "tests/evaluation/parallel.h"

namespace fovea::evaluation {

std::vector<BoxedFrameResult> RunBoxedFrames(const std::vector<BoxedFrame>& frames,
                                             const DetectInFrame& detect, int num_threads,
                                             const BoxedFrameDone& done) {
  std::vector<BoxedFrameResult> results(frames.size());
  std::mutex mutex;  // guards done
  ForEachIndex(frames.size(), num_threads, [&](std::size_t i) {
    const auto start = std::chrono::steady_clock::now();
    const Detections detections = detect(frames[i].frame);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    BoxedFrameResult& result = results[i];
    result = {frames[i].source,
              frames[i].name,
              ScoreBoxes(frames[i], detections.labels),
              time.count(),
              {}};
    for (const DetectedObject& object : detections.objects) {
      const auto judged = result.scores.judged.find(object.label);
      if (judged == result.scores.judged.end()) continue;
      result.predictions.push_back({object.confidence, judged->second});
    }
    const std::scoped_lock lock(mutex);
    if (done) done(frames[i], detections);
  });
  return results;
}

}  // namespace fovea::evaluation
