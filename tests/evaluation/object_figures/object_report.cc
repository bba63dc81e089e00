#include "tests/evaluation/object_figures/object_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <numbers>

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

void PrintHonesty(std::ostream& out, const ObjectRun& run) {
  fmt::print(out,
             "\nerrors of boxes within one and two of the standard deviations said (honest: "
             "68 and 95 %)\n  {:28} {:>6} {:>6} {:>6} {:>13} {:>12}\n",
             "mm; yaw in deg", "count", "one %", "two %", "median error", "median sigma");
  for (const auto& [group, numbers] : HonestiesOf(run)) {
    for (const Honesty& h : numbers) {
      const double unit = h.name == "yaw" ? 180 / std::numbers::pi : 1000;
      fmt::print(out, "  {:28} {:6} {:6.0f} {:6.0f} {:13.1f} {:12.1f}\n", group + ", " + h.name,
                 h.count, 100 * h.within_one, 100 * h.within_two, unit * h.median_error,
                 unit * h.median_sigma);
    }
  }
}

}  // namespace

void PrintObjects(std::ostream& out, const ObjectRun& run) {
  PrintBoxes(out, run);
  PrintShapes(out, run);
  PrintHonesty(out, run);
  const auto [right, count] = RightColors(run);
  fmt::print(out, "\ncolour by name: {:.1f}% of {} things in one colour\n",
             100.0 * right / std::max(1, count), count);
  const Score score = ScoreOf(run.on_objects);
  fmt::print(out,
             "objects on objects: {} true, {} answered, precision {:.1f}%, recall {:.1f}%; "
             "stands_on exactly right {:.1f}%\n",
             run.on_objects.truth, run.on_objects.answered, 100 * score.precision,
             100 * score.recall,
             100.0 * run.stands_right / std::max<std::size_t>(1, run.objects.size()));
  const Score leaning = ScoreOf(run.leaning);
  fmt::print(out, "leaning: {} true, {} answered, precision {:.1f}%, recall {:.1f}%\n",
             run.leaning.truth, run.leaning.answered, 100 * leaning.precision,
             100 * leaning.recall);
  fmt::print(out, "stage \"objects\" {:.2f} ms (90 % below {:.2f}), for ten objects {:.2f} ms\n",
             Median(run.objects_ms), Quantile(run.objects_ms, 0.9), TenObjectsMs(run));
}

}  // namespace fovea::evaluation
