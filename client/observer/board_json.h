// What the page is told, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "client/observer/board.h"

namespace fovea::observer {

nlohmann::json ServerJson(const std::string& address, const LinkState& state,
                          const v1::Observer* observer);

// One line of the list of robots.
nlohmann::json RobotJson(const ShownFrame& shown, double rate_hz);

nlohmann::json ObserverJson(const v1::Observer& observer);

// All of a frame but its images, with the names of the contract.
std::string FrameJson(const ShownFrame& shown);

}  // namespace fovea::observer
