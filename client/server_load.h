#pragma once

#include <optional>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::client {

// How busy a server is, by what GetStatistics says of the time between two of its answers. Knows no
// network.
class ServerLoad {
 public:
  void Note(const v1::GetStatisticsResponse& statistics);

  // Frames of more robots wait there than can be computed.
  bool is_overloaded() const { return num_waiting_ > 0; }

  // Seconds from one answer to the next that each robot gets if they take turns and `more` of them
  // come; 0 where there was nothing to do. None where that is not known: before it was noted twice.
  std::optional<double> Turn(int more) const;

 private:
  std::optional<v1::GetStatisticsResponse> last_;
  std::optional<double> s_per_frame_;
  double num_waiting_ = 0;
};

}  // namespace fovea::client
