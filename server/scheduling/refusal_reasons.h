// Limits for which calls and streams of robots are refused, as fovea_refused_total names them; what
// is refused for other reasons is counted by its status code.
#pragma once

#include <array>

namespace fovea::server {

inline constexpr const char* kQueueFull = "QUEUE_FULL";
inline constexpr const char* kRobotLimit = "ROBOT_LIMIT";
inline constexpr const char* kDisplaced = "DISPLACED";
inline constexpr const char* kStreamLimit = "STREAM_LIMIT";
inline constexpr const char* kHostStreamLimit = "HOST_STREAM_LIMIT";
inline constexpr const char* kRobotStreamLimit = "ROBOT_STREAM_LIMIT";

inline constexpr std::array kRefusalReasons{kQueueFull,   kRobotLimit,      kDisplaced,
                                            kStreamLimit, kHostStreamLimit, kRobotStreamLimit};

}  // namespace fovea::server
