// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.4784,
      .functions = {{
          {{-10.345, -7.3935, -5.2152, -4.2399, -3.4743}, {0.93893, 0.54716, 1.9106, -1.5086, 0.998, -1.9772}},  // its visible area
          {{-5.2126, -2.8405, -2.0116, -1.5672, -1.0466}, {1.111, 0.27496, -1.9335, -0.73457, -1.7364, -2.4513}},  // its largest extent
          {{-3.8621, -2.769, -1.8962, -1.3169, kNone}, {-0.0084281, -0.029111, -0.60384, -0.26187, 2.4559, 0}},  // its height
          {{-1.8188, -0.88386, -0.48163, -0.20217, -0.059811}, {0.88853, -0.55512, 0.82395, 1.7796, -7.4231, 10.543}},  // how slender it is
          {{-1.1374, -0.59991, -0.25453, 0.047871, 0.89772}, {0.11524, 0.14534, 1.7313, -2.216, -1.403, 2.5994}},  // how much of its extent is solid
          {{0.74712, 1.0313, 1.3823, 1.9156, 2.4945}, {-0.1563, -2.3933, -1.8259, 1.2716, 1.2393, 1.8044}},  // its distance
          {{1, kNone, kNone, kNone, kNone}, {-2.5749, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{kNone, kNone, kNone, kNone, kNone}, {0, 0, 0, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.031008, 0.39583, 0.99375, kNone, kNone}, {5.8831, -2.8783, -3.2138, 34.57, 0, 0}},  // how much of it faces up
          {{0.82353, kNone, kNone, kNone, kNone}, {-3.5006, -14.594, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.86381, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.17021, kNone, kNone, kNone, kNone}, {-5.6319, 10.766, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-1.8563, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0033113, 0.13333, kNone, kNone, kNone}, {-1.6508, -5.8335, 6.169, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.42073, 0.55556, 0.72985, kNone}, {3.8362, -7.3537, -3.3758, 5.9941, -5.6754, 0}},  // what is farther away beyond its border
          {{0.12698, kNone, kNone, kNone, kNone}, {-8.6582, 4.9625, 0, 0, 0, 0}},  // what is in front of it
          {{0.11905, 0.33333, 0.5, kNone, kNone}, {-1.1594, -2.2843, -2.213, 7.1371, 0, 0}},  // another segment is in front of it
          {{0.003268, kNone, kNone, kNone, kNone}, {0.80774, 1.1602, 0, 0, 0, 0}},  // what rises beside it
          {{0.042802, 0.14394, 0.35714, kNone, kNone}, {2.2281, -3.6924, -2.0534, 2.5575, 0, 0}},  // what is level with it
          {{0.0099096, 0.125, 0.2625, 0.5, 0.71703}, {-0.99327, -1.0521, -2.6294, 2.3763, -13.994, -4.446}},  // another segment touches it
          {{0.31915, 0.80667, 1, kNone, kNone}, {1.112, 0.26229, -6.0504, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-0.93254, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-0.82421, -0.30032, 1.5394, 0, 0, 0}},  // how many segments it consists of
          {{0, 5.9617, 6, kNone, kNone}, {-0.077156, 0.0056638, -12.201, 0, 0, 0}},  // how well its parts belong together
          {{2.616, 5.9619, 6, kNone, kNone}, {-0.60058, -0.35468, -47.868, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.54906, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4515, 4.0388, kNone, kNone}, {1.7322, -0.95745, 0.47053, 2.0633, 0, 0}},  // how its colour differs from the background
          {{0.17857, 0.36236, 0.53873, kNone, kNone}, {-7.5509, 2.9039, 3.9471, 0.34857, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {-0.50806, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.63183, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.2817, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-4.0501, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.54097, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {1.0587, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.193, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0054895, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1155, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.095962, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.2599, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.51129, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.22117, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.0145, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {9.3958, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2099, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {3.575, -3.417, -0.2975, -0.5626, 0.3455, -1.114, -0.002755, 0, 0.6973, -0.02739, 0.006719, -0.01172, -0.05569, -0.1291, -0.4485, -0.01659, -0.2196, 0.001135, -0.0496, -0.2113, 0.46, -0.2974, -0.6251, -0.206, 2.103, 0.403, 5.365, -1.314, -0.1724, -0.05089, -0.4813, -0.2267, 0.9208, 0.4726, -0.4279, 0.02638, -0.04609, -0.174, -0.1734, 0.07863, 0.07096, 0.3993, 0.1747, -0.02895}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
