#include "tests/evaluation/output.h"

#include <unistd.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fovea::evaluation {

void ShowProgress(const std::string& what, std::size_t done, std::size_t total) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::size_t width = 40, filled = total == 0 ? width : width * done / total;
  std::cerr << '\r' << what << " [" << std::string(filled, '#') << std::string(width - filled, '.')
            << "] " << done << '/' << total << "  " << (done == total ? "\r\33[2K" : "")
            << std::flush;
}

void WriteText(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text << '\n';
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

void WriteJson(const std::string& path, const nlohmann::json& json) {
  if (!path.empty()) WriteText(path, json.dump(2));
}

}  // namespace fovea::evaluation
