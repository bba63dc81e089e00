// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.367,
      .functions = {{
          {{-10.32, -7.3718, -5.2117, -4.2342, -3.4722}, {0.91875, 0.54514, 1.9143, -1.5975, 1.3435, -2.2273}},  // its visible area
          {{-5.1884, -2.8297, -2.0093, -1.5666, -1.0464}, {1.0894, 0.28076, -1.6494, -1.0709, -1.5259, -2.7459}},  // its largest extent
          {{-3.8611, -2.7633, -1.8967, -1.3173, kNone}, {0.22521, -0.17624, -0.92196, 0.038801, 2.3281, 0}},  // its height
          {{-1.8029, -0.88009, -0.47945, -0.20182, -0.059836}, {0.93226, -0.42664, 0.24924, 2.3656, -7.7476, 12.98}},  // how slender it is
          {{-1.1344, -0.60008, -0.25529, 0.046458, 0.89484}, {0.19813, -0.060891, 1.8317, -2.0709, -1.5513, 2.4835}},  // how much of its extent is solid
          {{0.747, 1.0312, 1.3822, 1.9161, 2.4946}, {-0.11432, -2.3543, -1.9463, 1.3504, 1.2522, 2.0581}},  // its distance
          {{1, kNone, kNone, kNone, kNone}, {-2.7213, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.057143, 1, kNone, kNone, kNone}, {-3.5024, 3.8757, 0, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.032609, 0.4, 0.98844, kNone, kNone}, {5.6777, -2.3827, -4.1079, -1.5784, 0, 0}},  // how much of it faces up
          {{0.82353, kNone, kNone, kNone, kNone}, {-3.614, -14.663, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.89606, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.17021, kNone, kNone, kNone, kNone}, {-5.4417, 10.274, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-1.8846, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0033557, 0.13376, kNone, kNone, kNone}, {-2.168, -5.8053, 6.1968, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.42017, 0.55556, 0.73, kNone}, {5.6217, -10.115, -2.6257, 6.2806, -6.6038, 0}},  // what is farther away beyond its border
          {{0.12833, kNone, kNone, kNone, kNone}, {-7.7143, 2.6539, 0, 0, 0, 0}},  // what is in front of it
          {{0.12, 0.33491, 0.5, kNone, kNone}, {-1.7846, -1.8122, -3.9768, 10.025, 0, 0}},  // another segment is in front of it
          {{0.0053381, kNone, kNone, kNone, kNone}, {0.65606, 0.041972, 0, 0, 0, 0}},  // what rises beside it
          {{0.041812, 0.14286, 0.35714, kNone, kNone}, {2.3881, -2.5372, -3.0328, 2.2838, 0, 0}},  // what is level with it
          {{0.010471, 0.125, 0.26496, 0.5, 0.71739}, {-1.717, -1.3619, -2.4457, 2.8533, -12.738, -4.1645}},  // another segment touches it
          {{0.30769, 0.8, 1, kNone, kNone}, {1.0133, 0.61587, -6.5791, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-0.78031, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-0.61369, -0.58435, 1.5162, 0, 0, 0}},  // how many segments it consists of
          {{0, 5.96, 6, kNone, kNone}, {-0.083871, 0.028108, -14.16, 0, 0, 0}},  // how well its parts belong together
          {{2.6199, 5.96, 6, kNone, kNone}, {-0.59725, -0.29147, -39.075, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.54581, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4566, 4.0437, kNone, kNone}, {1.925, -1.1466, 0.36527, 1.7499, 0, 0}},  // how its colour differs from the background
          {{0.17623, 0.35976, 0.53659, kNone, kNone}, {-8.3935, 3.9619, 2.8748, 1.7955, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {-0.60508, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.63563, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.6385, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-3.9615, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.60492, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.92404, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.5548, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.0050485, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1157, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.075882, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.9709, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.75635, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.22428, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.0952, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {9.0687, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.2493, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {3.609, -3.144, -1.204, -0.5823, 0.1988, -1.073, -0.002894, -0.06089, 0.7255, -0.02891, 0.006926, -0.01144, -0.05619, -0.1418, -0.2043, -0.01542, -0.2632, 0.0005118, 0.003014, -0.2745, 0.4809, -0.2474, -0.5062, -0.1819, 2.114, 0.3989, 5.792, -1.409, -0.205, -0.05111, -0.5545, -0.2214, 1.027, 0.4115, -0.4971, 0.02444, -0.04596, -0.1372, -0.1508, 0.1159, 0.07184, 0.4302, 0.1703, -0.02972}
      // clang-format on
  };
  return model;
}

}  // namespace fovea

