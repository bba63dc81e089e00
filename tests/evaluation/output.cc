#include "tests/evaluation/output.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fovea::evaluation {
namespace {

std::string NotWritten(const std::string& path) { return path + ": cannot be written"; }

}  // namespace

void ShowProgress(const std::string& what, std::size_t done, std::size_t total) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::size_t width = 40, filled = total == 0 ? width : width * done / total;
  std::cerr << '\r' << what << " [" << std::string(filled, '#') << std::string(width - filled, '.')
            << "] " << done << '/' << total << "  " << (done == total ? "\r\33[2K" : "")
            << std::flush;
}

std::string WhyNotWritable(const std::string& path) {
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(path, ignored);
  if (!std::ofstream(path, std::ios::app)) return NotWritten(path);
  if (is_new) std::filesystem::remove(path, ignored);
  return "";
}

void WriteText(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text << '\n';
  if (!file.flush()) throw std::runtime_error(NotWritten(path));
}

void WriteJson(const std::string& path, const nlohmann::json& json) {
  if (!path.empty()) WriteText(path, json.dump(2));
}

}  // namespace fovea::evaluation
