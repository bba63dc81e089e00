// What the same camera might as well have seen of a scene.
#pragma once

#include <array>

#include "tests/evaluation/dataset.h"
#include "tests/evaluation/real_frames/boxed_frames.h"

namespace fovea::evaluation {

struct Variant {
  bool mirrored = false;   // left and right
  double voxel_share = 1;  // of the size of voxels: other pieces
};

// The first is the scene itself. More of them, with other sizes of all things, teach no more.
constexpr std::array<Variant, 3> kVariants = {{{}, {true, 0.88}, {false, 1.13}}};

// The frame and what is true of it; of the size of voxels they know nothing.
BoxedFrame VariantOf(const BoxedFrame& frame, const Variant& variant);
Scene VariantOf(const Scene& scene, const Variant& variant);

}  // namespace fovea::evaluation
