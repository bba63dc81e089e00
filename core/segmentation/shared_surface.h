// Which segments that do not touch lie on one surface.
#pragma once

#include <vector>

#include "core/segmentation/voxel_grid.h"
#include "core/types/lists.h"

namespace fovea {

struct SameSurface {
  double max_angle_deg = 0;  // between the normals of two voxels
  double max_offset_m = 0;   // of each voxel from the tangent plane of the other
};

// Keeps some 150 voxels of each segment at most, evenly; two segments are compared by all pairs of
// these.
class SegmentSurfaces {
 public:
  // `voxels`: of each segment.
  SegmentSurfaces(const VoxelGrid& grid, const Lists<int>& voxels, const SameSurface& same);

  // Whether of each of the two segments at least this share (> 0) of the voxels lies on the surface
  // of a voxel of the other.
  bool AreOne(int a, int b, double min_share) const;

 private:
  // Of all segments: one column each, for several voxels at a time.
  struct Columns {
    std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  };
  struct Range {
    int begin = 0, end = 0;
  };

  double ShareOnSurface(Range of, Range other) const;
  int CountOnSurface(Range of, Range other) const;

  float min_cosine_, max_offset_m_;
  Columns voxels_;
  std::vector<Range> ranges_;  // of each segment
};

}  // namespace fovea
