#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/options.h"

namespace fovea::server {

// What the operator says of the options of the method.
class OptionPolicy {
 public:
  // Which ones requests may change: none, neither the profile; those that look for less or report
  // less, and so cannot make a frame much dearer; all.
  enum class Clients { kNone, kSafe, kAll };

  OptionPolicy() = default;
  // `clients` is "none", "safe" or "all"; each of `fixed` is NAME=VALUE, which holds for every
  // frame whatever its profile. Throws std::invalid_argument that names flag, option and reason.
  OptionPolicy(const std::string& clients, const std::vector<std::string>& fixed);

  bool MayChooseProfile() const { return clients_ != Clients::kNone; }
  bool MaySet(const std::string& name) const;
  // By name.
  const std::map<std::string, double>& fixed() const { return fixed_; }

  // `options` with what is fixed.
  DetectorOptions Applied(DetectorOptions options) const;

 private:
  Clients clients_ = Clients::kAll;
  std::map<std::string, double> fixed_;
};

}  // namespace fovea::server
