// Written by `fovea-eval objects`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -5.6623,
      .functions = {{
          {{-10.705, -8.0302, -5.2957, -4.3112, -3.5937}, {0.59922, 0.63229, 1.263, -0.84856, 0.31993, -0.83919}},  // its visible area
          {{-3.1038, -2.0955, -1.6208, -1.1837, kNone}, {0.53759, 0.39148, -2.286, -0.19911, -3.742, 0}},  // its largest extent
          {{-4.1387, -2.8886, -2.0252, -1.4406, kNone}, {0.42777, -0.10861, -0.80418, -0.23313, 0.77907, 0}},  // its height
          {{-1.8361, -0.84708, -0.44937, -0.1861, -0.053853}, {0.45274, -0.36607, 2.1386, 1.0776, -7.1884, 9.258}},  // how slender it is
          {{-1.1982, -0.65035, -0.28383, 0.018236, 0.79185}, {0.63304, 0.59459, 0.31667, -0.64463, -0.85425, 1.0839}},  // how much of its extent is solid
          {{0.61036, 0.85089, 1.118, 1.6871, 2.317}, {0.39527, -0.18334, -1.689, -2.5994, 1.1174, 1.5693}},  // its distance
          {{kNone, kNone, kNone, kNone, kNone}, {-4.5088, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.11816, 0.51613, 1, kNone, kNone}, {5.095, -1.7302, -5.1117, 0, 0, 0}},  // how much of it faces up
          {{0.75758, kNone, kNone, kNone, kNone}, {-3.3244, -7.147, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.76329, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.17164, kNone, kNone, kNone, kNone}, {-2.1453, 8.3793, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-2.5501, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0033003, 0.12782, kNone, kNone, kNone}, {-0.71131, -4.7073, 5.189, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.41387, 0.5625, 0.74233, kNone}, {4.2625, -4.3562, -4.8754, 4.1327, -5.9615, 0}},  // what is farther away beyond its border
          {{0.045553, kNone, kNone, kNone, kNone}, {-15.39, 8.9456, 0, 0, 0, 0}},  // what is in front of it
          {{0.1369, 0.34796, 0.5, kNone, kNone}, {1.2056, -4.8232, -3.2948, 9.893, 0, 0}},  // another segment is in front of it
          {{kNone, kNone, kNone, kNone, kNone}, {-4.9713, 0, 0, 0, 0, 0}},  // what rises beside it
          {{0.052573, 0.17021, 0.375, kNone, kNone}, {-0.31457, -2.0078, 1.9333, -2.8293, 0, 0}},  // what is level with it
          {{0.0067265, 0.12366, 0.26205, 0.48101, 0.6875}, {-0.62124, -0.79643, -0.6696, -0.90511, -7.0572, -6.4211}},  // another segment touches it
          {{0.32624, 0.80952, 1, kNone, kNone}, {0.92663, -0.31002, -5.9897, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-1.3227, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-0.8549, -0.26686, 1.9544, 0, 0, 0}},  // how many segments it consists of
          {{0, 6, kNone, kNone, kNone}, {-0.060812, -0.12345, 0, 0, 0, 0}},  // how well its parts belong together
          {{2.5889, 6, kNone, kNone, kNone}, {-0.50609, -0.73847, 0, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.75105, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4994, 4.081, kNone, kNone}, {1.6223, -0.84466, 0.81332, 1.2883, 0, 0}},  // how its colour differs from the background
          {{0.19157, 0.38372, 0.55582, kNone, kNone}, {-4.1312, 1.8751, 1.7111, 1.2356, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.20625, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.50078, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.5079, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-3.1862, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.44129, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.70597, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.4307, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0017375, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4973, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.11908, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2793, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.060098, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.001547, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.82986, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {8.6205, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.71096, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {5.134, -1.278, -1.678, 0.4243, 0.256, -0.2074, 0, 0.9526, -0.02679, 0.00568, 0.003807, -0.08065, -0.08524, 0.3178, -0.02254, -0.1223, -0.001903, -0.09342, -0.1421, 0.2072, -0.4643, -0.5831, -0.3878, 1.727, 0.5647, 5.074, -0.6686, 0.07591, -0.04723, -0.3475, -0.1888, 0.8092, 0.3103, -0.506, 0.0105, -0.05749, -0.2267, -0.09955, 0.01014, -0.0005842, 0.3407, 0.1679, -0.01783}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
