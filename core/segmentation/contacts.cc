#include "core/segmentation/contacts.h"

#include <algorithm>
#include <cstdint>

#include "core/segmentation/cell_index.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

struct Place {
  std::uint64_t key;  // of the voxel's cell
  int voxel;
};

// Of the voxels of segments, by cell.
std::vector<Place> SortedPlaces(const VoxelGrid& grid, const std::vector<int>& labels) {
  std::vector<Place> places;
  InterruptionPoint();
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) {
    if (labels[v] != 0) places.push_back({CellKey(grid.voxels[v].cell), v});
  }
  InterruptionPoint();
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.key < b.key; });
  return places;
}

// Calls visit(voxel, other) for all pairs where the cell of `other` lies `first` to `last` in the
// order of cells behind that of `voxel`.
template <typename Visit>
void ForEachPair(const std::vector<Place>& places, std::uint64_t first, std::uint64_t last,
                 Visit visit) {
  auto begin = places.begin();
  LongLoop loop;
  for (const Place& place : places) {
    loop.Turn();
    while (begin != places.end() && begin->key < place.key + first) ++begin;
    for (auto other = begin; other != places.end() && other->key <= place.key + last; ++other) {
      visit(place.voxel, other->voxel);
    }
  }
}

}  // namespace

std::vector<VoxelEdge> FindContacts(const VoxelGrid& grid, const std::vector<int>& labels,
                                    int reach_cells) {
  const std::vector<Place> places = SortedPlaces(grid, labels);
  std::vector<VoxelEdge> contacts;
  const auto add = [&](int a, int b) {
    if (labels[a] != labels[b]) contacts.push_back({std::min(a, b), std::max(a, b)});
  };
  const int reach = reach_cells;
  // Half of the neighbourhood, all cells of one x and y at a time, so that each pair is met once.
  ForEachPair(places, 1, CellKeyStep({0, 0, reach}), add);
  for (int x = 0; x <= reach; ++x) {
    for (int y = x > 0 ? -reach : 1; y <= reach; ++y) {
      ForEachPair(places, CellKeyStep({x, y, -reach}), CellKeyStep({x, y, reach}), add);
    }
  }
  return contacts;
}

}  // namespace fovea
