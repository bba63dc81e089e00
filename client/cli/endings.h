// The endings of names of files, in letters of either case.
#pragma once

#include <filesystem>
#include <string>

namespace fovea::cli {

// Letters of ASCII in lower case.
inline std::string Lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// ".png" of "a.PNG"; empty where there is none.
inline std::string LowerEnding(const std::string& path) {
  return Lower(std::filesystem::path(path).extension().string());
}

inline bool IsPngName(const std::string& path) { return LowerEnding(path) == ".png"; }

inline bool IsJpegName(const std::string& path) {
  const std::string ending = LowerEnding(path);
  return ending == ".jpg" || ending == ".jpeg";
}

}  // namespace fovea::cli
