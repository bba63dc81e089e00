#pragma once

#include <stdexcept>

namespace fovea::server {

// Thrown for callers that are not let in.
class Unauthenticated : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Thrown for callers that are known and may not do this.
class PermissionDenied : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fovea::server
