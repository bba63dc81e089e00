#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace fovea::server {

// Reads the file of --config. CLI11 itself names neither file nor line of a key that is no flag.
class ConfigFile : public CLI::ConfigTOML {
 public:
  // `app` has the flags, --config among them, and must outlive this.
  explicit ConfigFile(const CLI::App& app) : app_(app) {}

  // Throws std::invalid_argument with file, line and what may have been meant.
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  [[noreturn]] void Fail(std::size_t line, const std::string& what) const;
  void Check(const CLI::ConfigItem& item, const std::string& text) const;
  // What is wrong with it; empty where nothing is. `option`: null where there is none of this name.
  std::string Problem(const CLI::Option* option, const CLI::ConfigItem& item,
                      const std::string& key) const;
  std::string Remedy(const std::string& key) const;

  const CLI::App& app_;
};

}  // namespace fovea::server
