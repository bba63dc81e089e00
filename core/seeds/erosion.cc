#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/seeds/morphology.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr float kOutside = std::numeric_limits<float>::infinity();

// Minima over 1, 2, 4, … pixels to the right of each pixel of a row, up to `widest` of them. The
// row has a margin on both sides.
class RunMinima {
 public:
  RunMinima(int cols, int margin, int widest)
      : margin_(margin),
        levels_(std::bit_width(static_cast<unsigned>(widest)),
                std::vector<float>(static_cast<std::size_t>(cols + 2 * margin), kOutside)) {}

  FOVEA_INLINE void Set(const float* row) {
    std::copy_n(row, levels_[0].size() - 2 * static_cast<std::size_t>(margin_),
                levels_[0].begin() + margin_);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      const std::size_t width = std::size_t{1} << (level - 1);
      const float* half = levels_[level - 1].data();
      float* whole = levels_[level].data();
      const std::size_t count = levels_[level].size() - width;
      for (std::size_t x = 0; x < count; ++x) whole[x] = std::min(half[x], half[x + width]);
    }
  }

  // Starts at the first pixel of the row.
  FOVEA_INLINE const float* Level(int level) const {
    return levels_[static_cast<std::size_t>(level)].data() + margin_;
  }

 private:
  int margin_;
  std::vector<std::vector<float>> levels_;
};

// A row of the disk. Its minimum is the smaller of two overlapping runs of 2^level pixels.
struct DiskRow {
  int rise = 0;  // above and below the centre
  int half_width = 0;
  int level = 0;
};

std::vector<DiskRow> DiskRows(int radius_px) {
  std::vector<DiskRow> rows;
  for (int rise = 0; rise <= radius_px; ++rise) {
    const int half_width = static_cast<int>(std::sqrt(radius_px * radius_px - rise * rise));
    const auto width = static_cast<unsigned>(2 * half_width + 1);
    rows.push_back({rise, half_width, static_cast<int>(std::bit_width(width)) - 1});
  }
  return rows;
}

// The minima of a row over a row of the disk, taken into the rows above and below that have it in
// theirs.
FOVEA_INLINE void TakeMinima(const RunMinima& runs, const DiskRow& disk_row, int cols, float* above,
                             float* below) {
  const float* left_run = runs.Level(disk_row.level) - disk_row.half_width;
  const float* right_run =
      runs.Level(disk_row.level) + disk_row.half_width + 1 - (1 << disk_row.level);
  const auto take = [=](int x) { return std::min(left_run[x], right_run[x]); };
  if (above == below) {  // through the centre
    for (int x = 0; x < cols; ++x) above[x] = std::min(above[x], take(x));
    return;
  }
  for (int x = 0; x < cols; ++x) {
    const float run = take(x);
    above[x] = std::min(above[x], run);
    below[x] = std::min(below[x], run);
  }
}

}  // namespace

cv::Mat ErodeByDisk(const cv::Mat& map, int radius_px) {
  std::vector<DiskRow> disk = DiskRows(radius_px);
  // Rows of the disk that lie outside of the image wherever its centre is, as of a ribbon's.
  if (disk.size() > static_cast<std::size_t>(map.rows)) disk.resize(map.rows);
  const int margin = static_cast<int>(disk.size()) - 1;
  RunMinima runs(map.cols, radius_px, 2 * radius_px + 1);
  // With a margin for what lies outside of the image.
  cv::Mat eroded(map.rows + 2 * margin, map.cols, CV_32F, cv::Scalar::all(kOutside));
  RunInWidestRegisters([&] {
    for (int y = 0; y < map.rows; ++y) {
      InterruptionPoint();
      runs.Set(map.ptr<float>(y));
      const int center = y + margin;
      for (const DiskRow& row : disk) {
        TakeMinima(runs, row, map.cols, eroded.ptr<float>(center - row.rise),
                   eroded.ptr<float>(center + row.rise));
      }
    }
  });
  return eroded.rowRange(margin, margin + map.rows);
}

}  // namespace fovea
