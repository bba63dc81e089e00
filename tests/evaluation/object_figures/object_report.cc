#include "tests/evaluation/object_figures/object_report.h"

#include <fmt/ostream.h>

#include <algorithm>

#include "tests/evaluation/object_figures/object_statistics.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

void PrintBoxes(std::ostream& out, const ObjectRun& run) {
  fmt::print(out, "{:30} {:>6} {:>11} {:>11} {:>11} {:>12} {:>11} {:>12}\n",
             "boxes: median/90 % (IoU 10 %)", "count", "length mm", "width mm", "height mm",
             "centre mm", "yaw deg", "IoU");
  const auto pair = [](const MedianAndTail& m) {
    return fmt::format("{:.1f}/{:.0f}", m.median, m.tail);
  };
  for (const BoxFigures& f : BoxFiguresOf(run)) {
    fmt::print(out, "{:30} {:6} {:>11} {:>11} {:>11} {:>12} {:>11} {:>12}\n", f.name, f.count,
               pair(f.size_mm[0]), pair(f.size_mm[1]), pair(f.size_mm[2]), pair(f.center_mm),
               pair(f.yaw_deg), fmt::format("{:.2f}/{:.2f}", f.iou.median, f.iou.tail));
  }
}

void PrintShapes(std::ostream& out, const ObjectRun& run) {
  fmt::print(out, "\nshape is right\n");
  for (const auto& [name, counts] : RightShapes(run)) {
    fmt::print(out, "  {:16} {:5.1f}% of {}\n", name, 100.0 * counts.first / counts.second,
               counts.second);
  }
  fmt::print(out, "  {:16}", "truth \\ answer");
  for (const char* name : kShapeNames) fmt::print(out, " {:>10}", name);
  const Confusions counts = ConfusionsOf(run);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    fmt::print(out, "\n  {:16}", kShapeNames[i]);
    for (const int count : counts[i]) fmt::print(out, " {:10}", count);
  }
  fmt::print(out, "\n");
}

}  // namespace

void PrintObjects(std::ostream& out, const ObjectRun& run) {
  PrintBoxes(out, run);
  PrintShapes(out, run);
  const Score score = ScoreOf(run.on_objects);
  fmt::print(out,
             "\nobjects on objects: {} true, {} answered, precision {:.1f}%, recall {:.1f}%; "
             "stands_on exactly right {:.1f}%\n",
             run.on_objects.truth, run.on_objects.answered, 100 * score.precision,
             100 * score.recall,
             100.0 * run.stands_right / std::max<std::size_t>(1, run.objects.size()));
  fmt::print(out, "stage \"objects\" {:.2f} ms (90 % below {:.2f}), for ten objects {:.2f} ms\n",
             Median(run.objects_ms), Quantile(run.objects_ms, 0.9), Median(run.per_ten_ms));
}

}  // namespace fovea::evaluation
