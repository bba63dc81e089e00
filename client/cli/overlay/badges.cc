#include "client/cli/overlay/badges.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/palette.h"
#include "client/cli/words.h"

namespace fovea::cli {

void Badges::Add(const cv::Point& corner, std::vector<std::string> lines,
                 const cv::Scalar& background) {
  const cv::Size size = BadgeSize(lines);
  const cv::Rect box = Place({corner, size});
  badges_.push_back({box, std::move(lines), background});
}

void Badges::Draw(cv::Mat& picture) const {
  for (const Badge& badge : badges_) {
    DrawBadge(picture, badge.box.tl(), badge.lines, badge.background);
  }
}

// Moves it down until it covers none of those before.
cv::Rect Badges::Place(cv::Rect box) const {
  box.x = std::clamp(box.x, 0, std::max(0, picture_.width - box.width - 1));
  box.y = std::clamp(box.y, 0, std::max(0, picture_.height - box.height - 1));
  for (bool moved = true; moved;) {
    moved = false;
    for (const Badge& other : badges_) {
      if ((box & other.box).empty()) continue;
      box.y = other.box.br().y + 1;
      moved = true;
    }
  }
  return box;
}

void AddBadge(const v1::Object& object, const View& view, Badges& badges) {
  std::vector<std::string> lines{std::to_string(object.label()) + "  " +
                                 std::to_string(std::lround(object.confidence() * 100)) + "%"};
  if (object.track_id() != 0) lines[0] += "  #" + std::to_string(object.track_id());
  if (!object.blocked_by().empty()) {
    std::ostringstream first;
    first << "first";
    for (const std::uint32_t label : object.blocked_by()) first << ' ' << label;
    lines.push_back(first.str());
  }
  if (object.grasps().empty() && !object.no_grasps().empty()) {
    lines.push_back(std::string("no grasp: ") + WordOf(object.no_grasps(0).reason()));
  }
  // Grippers come from above; below there is room.
  const v1::BoundingBox2D& bounds = object.bounding_box();
  const cv::Point corner = view.At(bounds.x(), bounds.y() + bounds.height() + 1);
  badges.Add(corner, std::move(lines), ColorOf(object.label()));
}

}  // namespace fovea::cli
