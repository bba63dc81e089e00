// Written by `fovea-eval objects`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.3878,
      .functions = {{
          {{-10.713, -8.0504, -5.2952, -4.308, -3.5926}, {0.85061, 0.59199, 1.4936, -1.0683, 0.26389, -0.9905}},  // its visible area
          {{-3.1093, -2.0944, -1.6193, -1.1795, kNone}, {0.74117, -0.22861, -2.26, -0.40452, -3.3661, 0}},  // its largest extent
          {{-4.1485, -2.8928, -2.0235, -1.4382, kNone}, {0.59893, -0.56526, -0.66519, 0.68404, 0.15257, 0}},  // its height
          {{-1.8334, -0.8441, -0.44757, -0.18559, -0.05376}, {0.55638, -0.66481, 1.9593, 1.3431, -6.6748, 8.0086}},  // how slender it is
          {{-1.2007, -0.6522, -0.28342, 0.018731, 0.79295}, {0.40894, 0.42984, 0.90309, -1.0853, -1.0434, 1.8931}},  // how much of its extent is solid
          {{0.61108, 0.85202, 1.119, 1.6883, 2.3186}, {0.792, -0.24271, -1.9522, -2.9669, 1.5828, 0.82707}},  // its distance
          {{kNone, kNone, kNone, kNone, kNone}, {-5.3652, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.12057, 0.51918, 1, kNone, kNone}, {5.9251, -3.1143, -4.5937, 0, 0, 0}},  // how much of it faces up
          {{0.75862, kNone, kNone, kNone, kNone}, {-3.5285, -6.7972, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {0.66439, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.1723, kNone, kNone, kNone, kNone}, {-4.9074, 10.822, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-2.4321, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.0040323, 0.13636, kNone, kNone, kNone}, {-0.97746, -8.0106, 8.3603, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.4127, 0.56081, 0.74, kNone}, {3.8858, -6.392, -4.5435, 4.4121, -3.6828, 0}},  // what is farther away beyond its border
          {{0.047431, kNone, kNone, kNone, kNone}, {-21.378, 15.553, 0, 0, 0, 0}},  // what is in front of it
          {{0.13544, 0.34615, 0.5, kNone, kNone}, {-0.5096, -3.8036, -5.9216, 16.71, 0, 0}},  // another segment is in front of it
          {{kNone, kNone, kNone, kNone, kNone}, {-4.7867, 0, 0, 0, 0, 0}},  // what rises beside it
          {{0.052441, 0.17105, 0.37838, kNone, kNone}, {0.27364, -4.4894, 5.1417, -4.2834, 0, 0}},  // what is level with it
          {{0.0072405, 0.125, 0.26371, 0.48296, 0.68868}, {-0.5716, -0.77254, -2.9801, -0.072868, -7.4476, -11.764}},  // another segment touches it
          {{0.32468, 0.81053, 1, kNone, kNone}, {0.58765, 0.17958, -7.0542, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4106, 0, 0, 0, 0, 0}},  // it is a single segment
          {{1.0986, 1.7918, kNone, kNone, kNone}, {-1.0467, -0.27441, 2.202, 0, 0, 0}},  // how many segments it consists of
          {{0, 6, kNone, kNone, kNone}, {-0.046471, -0.14065, 0, 0, 0, 0}},  // how well its parts belong together
          {{2.633, 6, kNone, kNone, kNone}, {-0.57111, -0.79011, 0, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.68161, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.4997, 4.0807, kNone, kNone}, {1.6274, -0.54114, 0.32953, 1.3569, 0, 0}},  // how its colour differs from the background
          {{0.19136, 0.38477, 0.55882, kNone, kNone}, {-6.0838, 3.958, -1.0853, 2.4132, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.02193, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.24746, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.1202, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-4.6814, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.55524, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.75101, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.9656, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.0013005, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1191, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.10426, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.5862, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.52901, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.12271, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.1771, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {8.8977, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.99284, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {4.421, -2.44, -2.711, -0.09107, 0.3648, 0.08743, 0, 0.9539, -0.02641, 0.004342, -0.006127, -0.07494, -0.1533, -0.4436, -0.02964, -0.2602, -0.00184, -0.1174, -0.2049, 0.1356, -0.4974, -0.7118, -0.3956, 1.955, 0.5136, 5.266, -0.9546, 0.008089, 0.02329, -0.49, -0.2778, 1.02, 0.3312, -0.6189, -0.00789, -0.04289, -0.1997, -0.1239, 0.08962, -0.04619, 0.4838, 0.1732, -0.02504}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
