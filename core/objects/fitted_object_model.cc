// Written by `fovea-eval objects`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -2.7847,
      .functions = {{
          {{-10.705, -8.0302, -5.2957, -4.3112, -3.5937}, {0.71765, 0.61834, 1.3225, -0.98851, 0.4257, -0.95213}},  // its visible area
          {{-3.1038, -2.0955, -1.6208, -1.1837, kNone}, {0.67005, 0.14257, -2.2702, -0.013481, -4.1243, 0}},  // its largest extent
          {{-4.1387, -2.8886, -2.0252, -1.4406, kNone}, {0.61945, -0.37747, -0.74468, -0.21697, 0.86951, 0}},  // its height
          {{-1.8361, -0.84708, -0.44937, -0.1861, -0.053853}, {0.64468, -0.58627, 2.0882, 1.065, -7.0604, 9.7335}},  // how slender it is
          {{-1.1982, -0.65035, -0.28383, 0.018236, 0.79185}, {0.66766, 0.53738, 0.42124, -0.82316, -1.0042, 1.6721}},  // how much of its extent is solid
          {{0.61036, 0.85089, 1.118, 1.6871, 2.317}, {0.41528, -0.23896, -1.6836, -2.6369, 1.2506, 1.4213}},  // its distance
          {{kNone, kNone, kNone, kNone, kNone}, {-4.9385, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.11816, 0.51613, 1, kNone, kNone}, {5.6837, -2.4719, -5.0683, 0, 0, 0}},  // how much of it faces up
          {{0.75758, kNone, kNone, kNone, kNone}, {-3.5938, -6.8668, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.84829, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.17164, kNone, kNone, kNone, kNone}, {-2.7101, 8.4749, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-2.4987, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0033003, 0.12782, kNone, kNone, kNone}, {-0.79749, -5.6735, 5.6077, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.41387, 0.5625, 0.74233, kNone}, {4.0434, -5.2984, -4.6609, 4.8529, -6.8359, 0}},  // what is farther away beyond its border
          {{0.045553, kNone, kNone, kNone, kNone}, {-17.906, 11.462, 0, 0, 0, 0}},  // what is in front of it
          {{0.1369, 0.34796, 0.5, kNone, kNone}, {0.50597, -4.4087, -3.8998, 10.357, 0, 0}},  // another segment is in front of it
          {{kNone, kNone, kNone, kNone, kNone}, {-4.5122, 0, 0, 0, 0, 0}},  // what rises beside it
          {{0.052573, 0.17021, 0.375, kNone, kNone}, {0.027972, -2.5178, 2.0512, -3.0179, 0, 0}},  // what is level with it
          {{0.0067265, 0.12366, 0.26205, 0.48101, 0.6875}, {-0.67685, -0.92394, -1.2103, -0.51137, -7.9581, -8.5387}},  // another segment touches it
          {{0.32624, 0.80952, 1, kNone, kNone}, {1.0023, -0.38445, -6.3486, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4198, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-0.94696, -0.17115, 1.9281, 0, 0, 0}},  // how many segments it consists of
          {{0, 6, kNone, kNone, kNone}, {-0.067365, -0.11745, 0, 0, 0, 0}},  // how well its parts belong together
          {{2.5889, 6, kNone, kNone, kNone}, {-0.53641, -0.78623, 0, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.76367, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4994, 4.081, kNone, kNone}, {1.6475, -0.85403, 0.76697, 1.4083, 0, 0}},  // how its colour differs from the background
          {{0.19157, 0.38372, 0.55582, kNone, kNone}, {-5.0294, 2.4183, 1.5067, 1.3232, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.056564, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.30261, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.8661, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-3.8492, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.50294, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.75363, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.5988, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.001095, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4807, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.11378, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4669, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.24474, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0047803, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.98707, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {9.1328, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.79006, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {4.628, -1.821, -2.567, 0.006779, 0.2112, -0.2093, 0, 0.9802, -0.02876, 0.006313, 0.0008907, -0.07903, -0.11, -0.03293, -0.02548, -0.1795, -0.001728, -0.08776, -0.1708, 0.2147, -0.4984, -0.6384, -0.3884, 1.83, 0.5742, 5.146, -0.8143, 0.02082, -0.02854, -0.43, -0.2281, 0.9222, 0.3313, -0.5409, 0.006616, -0.05685, -0.2166, -0.1142, 0.0413, 0.001805, 0.4053, 0.1779, -0.01981}
      // clang-format on
  };
  return model;
}

}  // namespace fovea

