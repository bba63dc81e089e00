// Written by `fovea-eval object-model`: the knots and slopes of each term.
#include "core/objects/object_model.h"

namespace fovea {

const ObjectModel& FittedObjectModel() {
  constexpr double kNone = TermFunction::kNoKnot;
  static const ObjectModel model{
      // clang-format off
      .bias = -1.6556,
      .functions = {{
          {{-10.116, -7.7315, -5.299, -4.2599, -3.4989}, {1.0222, 0.61164, 1.7062, -0.91466, 0.63706, -1.3909}},  // its visible area
          {{-3.1091, -2.0809, -1.5926, -1.0748, kNone}, {0.7569, 0.15314, -4.0486, 0.5495, -3.4092, 0}},  // its largest extent
          {{-4.1296, -2.8809, -1.9429, -1.3494, kNone}, {0.42291, -0.56744, -0.72434, 0.45271, 0.54271, 0}},  // its height
          {{-2.5077, -0.94763, -0.51415, -0.22129, -0.06922}, {0.62237, -0.29181, 0.21988, 1.6121, -3.5043, 5.3297}},  // how slender it is
          {{-0.94948, -0.45961, -0.15268, 0.27907, 1.3526}, {-0.10893, 0.14867, 1.4968, -1.9495, 1.9263, -0.53443}},  // how much of its extent is solid
          {{0.718, 0.967, 1.2767, 1.8273, 2.3927}, {0.19682, -1.3467, -3.2184, 0.76904, 1.0367, 5.1836}},  // its distance
          {{1, kNone, kNone, kNone, kNone}, {-1.114, 0, 0, 0, 0, 0}},  // how much of it lies under a support
          {{0.073529, 1, kNone, kNone, kNone}, {-2.5198, 2.2357, 0, 0, 0, 0}},  // how much of it is no higher than its support
          {{0.02907, 0.42515, 1, kNone, kNone}, {4.2304, -0.97567, -4.9403, 0, 0, 0}},  // how much of it faces up
          {{0.76923, kNone, kNone, kNone, kNone}, {-3.2719, -2.5523, 0, 0, 0, 0}},  // how much of its upper border is hidden or goes on
          {{kNone, kNone, kNone, kNone, kNone}, {-0.085347, 0, 0, 0, 0, 0}},  // it goes on above
          {{0.13636, kNone, kNone, kNone, kNone}, {-4.3228, 3.5267, 0, 0, 0, 0}},  // how much of it ends with the image
          {{kNone, kNone, kNone, kNone, kNone}, {-1.5775, 0, 0, 0, 0, 0}},  // it ends with the image
          {{0.11567, kNone, kNone, kNone, kNone}, {-9.5581, 9.263, 0, 0, 0, 0}},  // beyond much of its border nothing is measured
          {{0.25, 0.41667, 0.55, 0.73106, kNone}, {3.6691, -5.0511, -4.722, 5.2498, -5.6805, 0}},  // what is farther away beyond its border
          {{0.097938, kNone, kNone, kNone, kNone}, {-7.9076, 2.4966, 0, 0, 0, 0}},  // what is in front of it
          {{0.12349, 0.33333, 0.5, kNone, kNone}, {-2.3571, -1.3925, -1.92, 8.5733, 0, 0}},  // another segment is in front of it
          {{kNone, kNone, kNone, kNone, kNone}, {5.6019, 0, 0, 0, 0, 0}},  // what rises beside it
          {{0.043103, 0.1519, 0.33333, kNone, kNone}, {5.5559, -9.9883, 6.6686, -0.74172, 0, 0}},  // what is level with it
          {{0.017751, 0.15, 0.2963, 0.5, 0.72581}, {-2.2985, -0.97829, 0.66409, -4.1307, -14.406, -1.0696}},  // another segment touches it
          {{0.31915, 0.81159, 1, kNone, kNone}, {0.72143, 0.034645, -1.0834, 0, 0, 0}},  // whether it stands on something
          {{kNone, kNone, kNone, kNone, kNone}, {-0.35163, 0, 0, 0, 0, 0}},  // it is a single segment
          {{0.69315, 1.0986, 1.9459, kNone, kNone}, {-0.2287, 0.25317, -1.3823, 1.5339, 0, 0}},  // how many segments it consists of
          {{0, 6, kNone, kNone, kNone}, {-0.083975, 0.031226, 0, 0, 0, 0}},  // how well its parts belong together
          {{-3.843, 3.7611, 6, kNone, kNone}, {-0.58149, 0.075609, 0.033927, 0, 0, 0}},  // how well it belongs to something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.48822, 0, 0, 0, 0, 0}},  // its parts belong together and nothing else does
          {{2.4849, 3.2993, 3.8914, kNone, kNone}, {1.7178, -0.7568, 0.54854, 0.068527, 0, 0}},  // how its colour differs from the background
          {{0.18269, 0.37373, 0.5, kNone, kNone}, {-5.4193, -0.94389, 3.2825, 0.86832, 0, 0}},  // how much of its border touches the background
          {{kNone, kNone, kNone, kNone, kNone}, {0.41178, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.5213, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.84917, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {1.2161, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.31666, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.59263, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-2.2304, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.010415, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.4031, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.11455, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-1.6424, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.030907, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.25726, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {0.026807, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {7.0848, 0, 0, 0, 0, 0}},  // how it meets something next to it
          {{kNone, kNone, kNone, kNone, kNone}, {-0.38933, 0, 0, 0, 0, 0}},  // how it meets something next to it
      }},
      .usual = {3.901, -2.55, -2.332, -0.4721, 0.3373, -0.7275, -0.004648, -0.06203, 0.6404, -0.02597, -0.0005701, -0.01277, -0.04449, -0.1247, -0.1125, -0.01535, -0.2825, 0.004682, 0.06792, -0.2386, 0.3623, -0.09866, -0.3383, -0.0999, 2.011, 0.334, 5.294, -1.212, 0.151, -0.139, -0.21, 0.07403, 0.6124, 0.2948, -0.5765, 0.03924, -0.07228, -0.2374, -0.1345, -0.005707, 0.09486, -0.01185, 0.1374, -0.009308}
      // clang-format on
  };
  return model;
}

}  // namespace fovea
