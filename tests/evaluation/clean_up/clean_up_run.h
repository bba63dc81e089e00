// Scenes that a program cleans up, step by step.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/evaluation/clean_up/floor_world.h"

namespace fovea::evaluation {

struct CleanUpFlags {
  int num_scenes = 1;
  int num_things = 15;  // of each
  std::uint64_t first_seed = 1;
  std::string sensor = "kinect";  // as SensorOf takes it
  int num_threads = 1;
  std::string pictures;              // folder; empty = none
  std::vector<std::string> program;  // its command line
};

// What is left in the end.
struct LeftThing {
  std::string name;
  std::string reason;  // as the answer says it; empty: it was not found, or no answer says it
  bool can_be_taken = false;
  bool carries_another = false;

  // The answer has the thing and says why it cannot be taken, and the true solids agree.
  bool IsTrue() const { return !reason.empty() && (!can_be_taken || carries_another); }
};

struct CleanedScene {
  std::uint64_t seed = 0;
  std::size_t num_things = 0;
  std::vector<Attempt> attempts;
  std::vector<LeftThing> left;
  bool gave_up = false;  // four attempts for each thing did not do; `left` has no reasons
  std::string error;     // the program ended before its time, or said no decision
};

// Starts the program for each scene, tells it what the camera sees (client_dialog.h), does as it
// wants, and so on until it has had enough. What goes wrong with the program of one scene is that
// scene's error. Calls `on_end` with each scene in turn, as soon as it and those before it have
// ended, one call at a time.
using SceneEnded = std::function<void(const CleanedScene&)>;
std::vector<CleanedScene> CleanUp(const CleanUpFlags& flags, const SceneEnded& on_end);

}  // namespace fovea::evaluation
