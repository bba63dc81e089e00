// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.4778,
      .functions = {{
          {{-10.117, -7.7321, -5.2965, -4.2601, -3.4993}, {0.97852, 0.60258, 1.6606, -1.0059, 0.67659, -1.2811}},  // its visible area
          {{-3.1106, -2.0819, -1.5923, -1.0758, kNone}, {0.74443, 0.23112, -3.3444, 0.21262, -3.5363, 0}},  // its largest extent
          {{-4.1235, -2.8774, -1.9426, -1.3508, kNone}, {0.43965, -0.64255, -0.73457, 0.058387, 1.0298, 0}},  // its height
          {{-2.535, -0.95261, -0.51818, -0.22262, -0.069367}, {0.69319, -0.079471, 0.20619, 1.545, -3.7756, 5.0244}},  // how slender it is
          {{-0.94877, -0.45873, -0.15153, 0.27972, 1.3525}, {0.13877, 0.37179, 1.5234, -2.5856, 2.1352, -0.6196}},  // how much of its extent is solid
          {{0.718, 0.967, 1.2764, 1.8268, 2.3918}, {-0.44807, -0.89457, -2.9127, 0.84025, 0.77517, 5.4226}},  // its distance
          {{1, kNone, kNone, kNone, kNone}, {-1.0475, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.072961, 1, kNone, kNone, kNone}, {-2.5962, 2.3242, 0, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.027149, 0.41799, 1, kNone, kNone}, {4.6396, -1.5518, -4.5067, 0, 0, 0}},  // how much of it faces up
          {{0.76923, kNone, kNone, kNone, kNone}, {-4.9083, 1.188, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.80055, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.13542, kNone, kNone, kNone, kNone}, {-2.3593, 0.79047, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-1.6643, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.11765, kNone, kNone, kNone, kNone}, {-9.6477, 8.6273, 0, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.41667, 0.55263, 0.73333, kNone}, {3.7805, -6.2649, -2.8231, 4.5071, -5.3717, 0}},  // what is farther away beyond its border
          {{0.097403, kNone, kNone, kNone, kNone}, {-7.0052, 1.4311, 0, 0, 0, 0}},  // what is in front of it
          {{0.125, 0.33333, 0.5, kNone, kNone}, {-2.1925, -0.80271, -1.7385, 4.5085, 0, 0}},  // another segment is in front of it
          {{kNone, kNone, kNone, kNone, kNone}, {5.3703, 0, 0, 0, 0, 0}},  // what rises beside it
          {{0.042636, 0.15, 0.33333, kNone, kNone}, {5.85, -10.495, 6.4883, -0.77686, 0, 0}},  // what is level with it
          {{0.016854, 0.14815, 0.29348, 0.5, 0.72368}, {-2.8499, -1.4087, 2.8564, -5.9603, -12.261, -1.5982}},  // another segment touches it
          {{0.31429, 0.80769, 1, kNone, kNone}, {0.91318, -0.31754, -0.6698, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-0.44176, 0, 0, 0, 0, 0}},  // it is a single segment
          {{0.69315, 1.0986, 1.9459, kNone, kNone}, {-0.25483, 0.095275, -1.1026, 1.4704, 0, 0}},  // how many segments it consists of
          {{0, 6, kNone, kNone, kNone}, {-0.075741, 0.014494, 0, 0, 0, 0}},  // how well its parts belong together
          {{-3.888, 3.7354, 6, kNone, kNone}, {-0.572, 0.065766, -0.046993, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.47757, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.299, 3.8942, kNone, kNone}, {1.7108, -1.0352, 0.88597, 0.036071, 0, 0}},  // how its colour differs from the background
          {{0.18098, 0.37037, 0.5, kNone, kNone}, {-4.9204, -0.60753, 2.0199, 1.7746, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.18474, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2907, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1609, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {1.528, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.37256, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.60338, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.3407, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.010658, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.5573, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.094153, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.547, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.065076, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.2215, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.068249, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {7.5275, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.31995, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {3.826, -2.208, -2.531, -0.07794, 0.3322, -1.194, -0.004371, -0.0634, 0.6206, -0.03681, 0.005349, -0.008357, -0.04695, -0.1354, -0.1616, -0.01389, -0.2471, 0.004471, 0.05769, -0.2626, 0.3743, -0.1241, -0.3693, -0.1197, 1.943, 0.3258, 5.129, -1.089, 0.06815, -0.1184, -0.2887, 0.09348, 0.7244, 0.3014, -0.6071, 0.03999, -0.0799, -0.1961, -0.1267, 0.0121, 0.08215, -0.03039, 0.1474, -0.007666}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
