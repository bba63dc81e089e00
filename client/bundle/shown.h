#pragma once

#include <string>

namespace fovea::bundle {

// What comes from outside as it may go to people's terminals.
inline std::string Shown(const std::string& text) {
  constexpr std::size_t kMost = 60;
  std::string shown = text.substr(0, kMost);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return shown;
}

}  // namespace fovea::bundle
