// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -5.904,
      .functions = {{
          {{-10.13, -7.7567, -5.3164, -4.2706, -3.5073}, {1.0317, 0.56203, 1.3275, -0.65277, 0.10538, -0.17289}},  // its visible area
          {{-3.1258, -2.0924, -1.5965, -1.0784, kNone}, {0.61478, 0.46858, -3.3294, 0.49133, -5.9051, 0}},  // its largest extent
          {{-4.1372, -2.8936, -1.956, -1.3677, kNone}, {0.073146, -0.18088, -0.5474, 0.020377, 0.81277, 0}},  // its height
          {{-2.5463, -0.94414, -0.51153, -0.22201, -0.069856}, {0.45488, 0.20078, -0.040056, 1.3919, -2.4276, 3.5485}},  // how slender it is
          {{-0.95458, -0.46636, -0.15286, 0.27495, 1.3474}, {0.15315, 0.35775, 1.0362, -1.2838, 0.15268, -1.1371}},  // how much of its extent is solid
          {{0.71679, 0.96189, 1.2681, 1.8114, 2.3593}, {-0.31644, -1.249, -2.1927, -0.11851, 1.0631, 3.6327}},  // its distance
          {{0.071429, 1, kNone, kNone, kNone}, {-2.2637, 1.3621, 0.12469, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.031884, 0.43128, 1, kNone, kNone}, {3.6853, -0.54327, -4.6001, -0.086543, 0, 0}},  // how much of it faces up
          {{0.76471, kNone, kNone, kNone, kNone}, {-4.0649, -2.4216, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {-1.3979, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.10981, kNone, kNone, kNone, kNone}, {-3.1361, 3.1361, 0, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.41667, 0.55208, 0.73301, kNone}, {4.438, -3.9492, -2.7621, 5.5132, -6.7466, 0}},  // what is farther away beyond its border
          {{0.017766, 0.15, 0.29545, 0.5, 0.72}, {-0.025639, 0.025639, 0, -2.0871, -9.288, -1.2699}},  // another segment touches it
          {{0.69315, 1.0986, 1.9459, kNone, kNone}, {0.12406, -0.3268, -1.0888, 1.3867, 0, 0}},  // how many segments it consists of
          {{-3.924, 3.7078, 6, kNone, kNone}, {-0.52194, -0.092534, 0.037345, 0.14578, 0, 0}},  // how well it belongs to something next to it
          {{2.4849, 3.3166, 3.8904, kNone, kNone}, {1.8755, -0.96032, 0.48254, 0.59635, 0, 0}},  // how its colour differs from the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.56987, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.951, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1961, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2146, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.35872, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.5013, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.3399, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0087885, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1407, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.10682, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2974, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.087077, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.31125, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.62575, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {7.6084, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.91107, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {2.52, -1.671, -0.7706, 0.4931, 0.2853, -1.108, -0.06651, 0.6268, -0.03113, -0.04005, -0.03728, 1.081, -0.01499, -0.1987, 1.504, 5.663, 0.2076, -0.1783, -0.2951, -0.07394, 0.6903, 0.2475, -0.5983, 0.03266, -0.05935, -0.2183, -0.1036, -0.01601, 0.1148, 0.2772, 0.1461, -0.02181}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
