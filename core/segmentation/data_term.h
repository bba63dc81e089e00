// The data term of the scene labelling: what the object hypotheses and the background say of each
// voxel, or of several that are labelled together (paper Eq. 2, 5 and 6).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/segmentation/potts_energy.h"
#include "core/types/detections.h"

namespace fovea {

struct DataTermOptions {
  double gamma_per_m2 = 180;  // Eq. 5: how fast a hypothesis fades with distance; 1/m². Paper: 180
  double alpha = 0.1;         // Eq. 6: weight of the background. Paper: 0.1
  // Probabilities below this count as this, since Eq. 6 is 0 at a seed; a hypothesis is no choice
  // where Eq. 5 is below it on average.
  double min_probability = 1e-6;
  // Nor where the mean is farther than this from the seed; metres.
  double reach_m = 100;
};

// Eq. 6 where the nearest seed is this far: -ln(alpha (1 - p)), with p of Eq. 5; square metres.
float BackgroundCost(float squared_distance, const DataTermOptions& options);

// What takes one label each: single voxels, or several that are labelled together.
struct Sites {
  std::vector<Eigen::Vector3f> means;
  std::vector<float> variances_m2;  // mean squared distance of what they consist of to their means
  std::vector<float> weights;       // how many voxels they count as
};

// The choices of a PottsEnergy over the sites and what each costs: label 0 is the background, label
// k the hypothesis of seeds[k - 1], −ln p on average times the weight; for the background (Eq. 6)
// as if all of a site were as far from the nearest seed as it is on average (point by point:
// core/paper/background_costs.h).
//
// Throws TooComplex if there are more choices of site and hypothesis than memory should hold
// (2^25).
Lists<PottsEnergy::Choice> DataTerm(const Sites& sites, const std::vector<Seed>& seeds,
                                    const DataTermOptions& options = {});

}  // namespace fovea
