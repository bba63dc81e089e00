// Which generated scenes a command looks at.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/options.h"
#include "tests/support/sensor.h"

namespace fovea::evaluation {

struct GeneratedFlags {
  std::vector<std::string> kinds;  // of scenes::SceneKinds(); empty = all but empty_table
  int num_scenes = 8;              // of each kind, each seen by all sensors
  std::uint64_t first_seed = 1;
  std::vector<std::string> sensors = {"kinect", "realsense"};
  std::vector<std::string> settings;  // name=value
  bool give_gravity = false;
  bool leaning = false;  // add a thing that leans against a box where there is room
  int num_threads = 1;
  std::string json, plot, overlays;
};

// Which scenes there are, and how they are looked at.
void AddGeneratedFlags(CLI::App& command, GeneratedFlags& flags);

// Files of figures, of commands that have some.
void AddFigureFlags(CLI::App& command, GeneratedFlags& flags);

std::vector<std::string> KindsOf(const GeneratedFlags& flags);

// Profile "default" with the settings. Throws std::invalid_argument like SetOption.
DetectorOptions OptionsOf(const GeneratedFlags& flags);

// As fovea-scenes names them. Throws std::out_of_range.
scenes::SensorKind SensorOf(const std::string& name);

}  // namespace fovea::evaluation
