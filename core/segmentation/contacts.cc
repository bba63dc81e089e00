#include "core/segmentation/contacts.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "core/segmentation/cell_index.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

struct Place {
  std::uint64_t key;  // of the voxel's cell
  int voxel;
  int label;
};

// Of the voxels of segments, by cell.
std::vector<Place> SortedPlaces(const VoxelGrid& grid, const std::vector<int>& labels) {
  std::vector<Place> places;
  places.reserve(labels.size());
  InterruptionPoint();
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) {
    if (labels[v] != 0) places.push_back({CellKey(grid.voxels[v].cell), v, labels[v]});
  }
  InterruptionPoint();
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.key < b.key; });
  return places;
}

// Calls visit(place, other) for all pairs of two segments where the cell of `other` lies `first` to
// `last` in the order of cells behind that of `place`.
template <typename Visit>
void ForEachPair(const std::vector<Place>& places, std::uint64_t first, std::uint64_t last,
                 Visit visit) {
  auto begin = places.begin();
  LongLoop loop;
  for (const Place& place : places) {
    loop.Turn();
    while (begin != places.end() && begin->key < place.key + first) ++begin;
    for (auto other = begin; other != places.end() && other->key <= place.key + last; ++other) {
      if (other->label != place.label) visit(place, *other);
    }
  }
}

// What CellKeyStep makes the key of.
std::pair<std::int64_t, std::int64_t> StepInYAndZ(std::uint64_t key_step) {
  constexpr std::int64_t kRow = std::int64_t{1} << 21U;
  const auto step = static_cast<std::int64_t>(key_step);
  const std::int64_t y = (step + kRow / 2) >> 21;
  return {y, step - y * kRow};
}

}  // namespace

std::vector<VoxelEdge> FindContacts(const VoxelGrid& grid, const std::vector<int>& labels,
                                    int reach_cells) {
  struct Found {
    VoxelEdge contact;
    std::int64_t step = 0;  // in y
  };
  const std::vector<Place> places = SortedPlaces(grid, labels);
  const int reach = reach_cells;
  std::vector<VoxelEdge> contacts;
  std::vector<Found> found;  // of one x
  found.reserve(places.size());
  // Half of the neighbourhood, so that each pair is met once; all cells of one x at a time: most of
  // what is met is of the same segment, and that is soon told.
  for (int x = 0; x <= reach; ++x) {
    const std::uint64_t first = x == 0 ? 1 : CellKeyStep({x, -reach, -reach});
    found.clear();
    ForEachPair(places, first, CellKeyStep({x, reach, reach}), [&](const Place& a, const Place& b) {
      const auto [y, z] = StepInYAndZ(b.key - a.key - CellKeyStep({x, 0, 0}));
      if (std::abs(z) > reach) return;
      found.push_back({{std::min(a.voxel, b.voxel), std::max(a.voxel, b.voxel)}, y});
    });
    contacts.reserve(contacts.size() + found.size());
    for (int y = -reach; y <= reach; ++y) {
      for (const Found& one : found) {
        if (one.step == y) contacts.push_back(one.contact);
      }
    }
  }
  return contacts;
}

}  // namespace fovea
