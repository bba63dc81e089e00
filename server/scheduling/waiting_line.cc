#include "server/scheduling/waiting_line.h"

#include <algorithm>

namespace fovea::server {

std::size_t WaitingLine::Ahead(const std::string& robot, Clock::time_point now) {
  std::erase_if(places_, [&](const Place& place) { return place.until < now; });
  const auto own = std::ranges::find(places_, robot, &Place::robot);
  return static_cast<std::size_t>(own - places_.begin());
}

void WaitingLine::Keep(const std::string& robot, Clock::time_point until) {
  const auto own = std::ranges::find(places_, robot, &Place::robot);
  if (own != places_.end()) {
    own->until = until;
  } else if (places_.size() < max_places_) {
    places_.push_back({robot, until});
  }
}

void WaitingLine::Leave(const std::string& robot) {
  std::erase_if(places_, [&](const Place& place) { return place.robot == robot; });
}

}  // namespace fovea::server
