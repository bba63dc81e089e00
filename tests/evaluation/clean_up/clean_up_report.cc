#include "tests/evaluation/clean_up/clean_up_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace fovea::evaluation {
namespace {

std::string NameOf(const Attempt& attempt) {
  if (attempt.carried) return "something stands on it";
  std::string name = NameOf(attempt.outcome);
  if (attempt.TookIt()) name = "taken";
  return attempt.tipped ? name + ", tips over" : name;
}

bool Collides(const Attempt& attempt) {
  return attempt.outcome == Outcome::kHitsTarget || attempt.outcome == Outcome::kHitsNeighbor ||
         attempt.outcome == Outcome::kHitsFurniture;
}

std::string StateOf(const CleanedScene& scene, const LeftThing& left) {
  if (scene.gave_up) return "given up";
  if (left.IsTrue()) return left.reason + ": true";
  if (left.reason.empty()) return "not found";
  return left.reason + ": not true";
}

double Percent(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

bool EndsWell(const CleanedScene& scene) {
  return !scene.gave_up && scene.error.empty() &&
         std::all_of(scene.left.begin(), scene.left.end(),
                     [](const LeftThing& left) { return left.IsTrue(); });
}

void PrintCounts(std::ostream& out, const std::map<std::string, std::size_t>& counts) {
  for (const auto& [name, count] : counts) fmt::print(out, "  {:6} {}\n", count, name);
}

}  // namespace

void PrintSteps(std::ostream& out, const CleanedScene& scene) {
  fmt::print(out, "scene {}: {} things\n{:>4} {:14} {:5} {:>11} {}\n", scene.seed, scene.num_things,
             "step", "thing", "hand", "probability", "end");
  for (std::size_t i = 0; i < scene.attempts.size(); ++i) {
    const Attempt& attempt = scene.attempts[i];
    fmt::print(out, "{:4} {:14} {:5} {:11.2f} {}\n", i + 1,
               attempt.name.empty() ? "(nothing)" : attempt.name,
               attempt.grasp.gripper == 0 ? "jaw" : "cup", attempt.grasp.probability,
               NameOf(attempt));
  }
  for (const LeftThing& left : scene.left) {
    fmt::print(out, "left {:14} {}\n", left.name, StateOf(scene, left));
  }
  if (!scene.error.empty()) {
    fmt::print(out, "ended early: {}\n", scene.error);
  } else if (scene.left.empty()) {
    fmt::print(out, "the floor is empty\n");
  }
}

void PrintSummary(std::ostream& out, const std::vector<CleanedScene>& scenes) {
  std::size_t things = 0, attempts = 0, taken = 0, collisions = 0, empty = 0, well = 0;
  std::map<std::string, std::size_t> ends, left;
  for (const CleanedScene& scene : scenes) {
    things += scene.num_things;
    empty += scene.left.empty() && scene.error.empty() ? 1 : 0;
    well += EndsWell(scene) ? 1 : 0;
    for (const Attempt& attempt : scene.attempts) {
      ++attempts;
      taken += attempt.TookIt() ? 1 : 0;
      collisions += Collides(attempt) ? 1 : 0;
      ++ends[NameOf(attempt)];
    }
    for (const LeftThing& thing : scene.left) ++left[thing.name + ": " + StateOf(scene, thing)];
  }
  fmt::print(
      out,
      "{} scenes, {} things: {:.1f}% taken, by {} attempts of which {:.1f}% succeed and "
      "{:.1f}% collide\n{:.1f}% of the scenes end empty, {:.1f}% empty or with a true reason "
      "for all that is left\nattempts end:\n",
      scenes.size(), things, Percent(taken, things), attempts, Percent(taken, attempts),
      Percent(collisions, attempts), Percent(empty, scenes.size()), Percent(well, scenes.size()));
  PrintCounts(out, ends);
  fmt::print(out, "left:\n");
  PrintCounts(out, left);
}

nlohmann::json ToJson(const std::vector<CleanedScene>& scenes) {
  nlohmann::json all = nlohmann::json::array();
  for (const CleanedScene& scene : scenes) {
    nlohmann::json json = {{"seed", scene.seed},
                           {"things", scene.num_things},
                           {"gave_up", scene.gave_up},
                           {"error", scene.error},
                           {"attempts", nlohmann::json::array()},
                           {"left", nlohmann::json::array()}};
    for (const Attempt& attempt : scene.attempts) {
      json["attempts"].push_back({{"thing", attempt.name},
                                  {"gripper", attempt.grasp.gripper},
                                  {"probability", attempt.grasp.probability},
                                  {"end", NameOf(attempt)},
                                  {"taken", attempt.TookIt()}});
    }
    for (const LeftThing& left : scene.left) {
      json["left"].push_back(
          {{"thing", left.name}, {"reason", left.reason}, {"is_true", left.IsTrue()}});
    }
    all.push_back(json);
  }
  return all;
}

}  // namespace fovea::evaluation
