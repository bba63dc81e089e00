// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.3257,
      .functions = {{
          {{-10.322, -7.3751, -5.2141, -4.2338, -3.469}, {0.89517, 0.53604, 1.8888, -1.5438, 1.274, -2.1591}},  // its visible area
          {{-5.1914, -2.8319, -2.0107, -1.5658, -1.0455}, {1.0779, 0.2978, -1.5269, -1.2103, -1.6117, -2.6486}},  // its largest extent
          {{-3.8615, -2.7667, -1.8993, -1.3203, kNone}, {0.29212, -0.14672, -1.1438, 0.40511, 2.11, 0}},  // its height
          {{-1.8113, -0.88004, -0.47862, -0.20157, -0.05914}, {0.94867, -0.50389, 0.41139, 2.1723, -6.7913, 6.2073}},  // how slender it is
          {{-1.1324, -0.59798, -0.25446, 0.048485, 0.893}, {0.15838, 0.038778, 1.8006, -2.1106, -1.5511, 2.4662}},  // how much of its extent is solid
          {{0.747, 1.0315, 1.3815, 1.915, 2.4863}, {-0.10019, -2.3985, -1.9621, 1.4528, 1.2097, 1.5495}},  // its distance
          {{1, kNone, kNone, kNone, kNone}, {-2.7026, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.056911, 1, kNone, kNone, kNone}, {-3.4575, 3.7158, 0, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.032864, 0.4, 0.98921, kNone, kNone}, {5.4711, -2.0922, -4.1092, 7.4613, 0, 0}},  // how much of it faces up
          {{0.82353, kNone, kNone, kNone, kNone}, {-3.6456, -13.768, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.86999, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.17068, kNone, kNone, kNone, kNone}, {-5.1909, 9.8719, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-1.8913, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0032573, 0.13578, kNone, kNone, kNone}, {-2.2232, -5.6836, 6.0675, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.42, 0.55597, 0.73028, kNone}, {5.4252, -10.212, -1.8058, 5.6724, -6.1715, 0}},  // what is farther away beyond its border
          {{0.13115, kNone, kNone, kNone, kNone}, {-7.2962, 1.8159, 0, 0, 0, 0}},  // what is in front of it
          {{0.11947, 0.33333, 0.5, kNone, kNone}, {-1.1173, -3.0176, -2.4075, 8.5073, 0, 0}},  // another segment is in front of it
          {{0.005, kNone, kNone, kNone, kNone}, {0.63151, 0.36729, 0, 0, 0, 0}},  // what rises beside it
          {{0.041667, 0.14286, 0.35714, kNone, kNone}, {2.1295, -2.891, -1.8614, 1.8078, 0, 0}},  // what is level with it
          {{0.010453, 0.125, 0.26471, 0.5, 0.71667}, {-1.8584, -1.6083, -2.2305, 3.2752, -12.986, -4.3275}},  // another segment touches it
          {{0.31034, 0.8, 1, kNone, kNone}, {1.0225, 0.56022, -5.9447, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-0.81987, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-0.72353, -0.3994, 1.4031, 0, 0, 0}},  // how many segments it consists of
          {{0, 5.9482, 6, kNone, kNone}, {-0.0927, 0.043524, -12.487, 0, 0, 0}},  // how well its parts belong together
          {{2.596, 5.9483, 6, kNone, kNone}, {-0.62606, -0.17428, -35.238, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.48221, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4565, 4.0444, kNone, kNone}, {1.895, -1.047, 0.17768, 1.741, 0, 0}},  // how its colour differs from the background
          {{0.17647, 0.35948, 0.53365, kNone, kNone}, {-8.3514, 4.0533, 2.3644, 1.852, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {-0.72716, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.53013, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.8704, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-3.6517, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.66042, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.98279, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.3915, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0050621, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.3637, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.084167, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.0258, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {1.0259, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.19117, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.073, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {8.9439, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.96008, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {3.622, -2.988, -1.407, -0.6501, 0.2746, -1.071, -0.002872, -0.06233, 0.7407, -0.02907, 0.006723, -0.01085, -0.05637, -0.1428, -0.2437, -0.01472, -0.2491, 0.0006838, -0.01624, -0.2916, 0.4931, -0.2602, -0.5706, -0.1722, 2.237, 0.3504, 5.73, -1.407, -0.2482, -0.04261, -0.6095, -0.2059, 1.129, 0.4412, -0.4684, 0.0245, -0.05559, -0.1514, -0.1573, 0.1591, 0.06121, 0.4245, 0.1674, -0.02335}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
