// A robot of bad intent or bad luck: what a server has to survive while it serves the others.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::load {

// Until it is told to stop: calls that are taken back or have no time, frames that are damaged,
// streams that end in the middle or whose answers nobody reads, connections that send noise or
// nothing. `frame` is a good one. Returns how often each was done.
std::map<std::string, std::uint64_t> RunSaboteur(const std::string& server, const v1::Frame& frame,
                                                 unsigned seed, const std::stop_token& stop);

}  // namespace fovea::load
