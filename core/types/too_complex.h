// What ends a detection whose frame, with these options, is beyond what the method can hold.
#pragma once

#include <stdexcept>

namespace fovea {

struct TooComplex : std::length_error {
  using std::length_error::length_error;
};

}  // namespace fovea
