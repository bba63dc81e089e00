#include "client/observer/history/past.h"

#include <optional>
#include <utility>

#include "client/observer/exif.h"

namespace fovea::observer {
namespace {

// Of a list, whose pictures are previews; what makes frames large stays on the disk.
v1::WatchedFrame ListedOf(v1::WatchedFrame frame) {
  frame.set_preview(WithoutExif(PictureOf(frame)));
  frame.clear_picture();
  frame.clear_depth();
  frame.clear_frame();
  frame.clear_answer();
  return frame;
}

}  // namespace

const std::string& PictureOf(const v1::WatchedFrame& frame) {
  const v1::ColorImage& color = frame.frame().color();
  const bool is_shown = frame.picture().empty() && color.encoding() == v1::COLOR_ENCODING_JPEG;
  return is_shown ? color.data() : frame.picture();
}

void ShowPast(const History& history, std::size_t server, Board* board) {
  const std::string& address = board->AddressOf(server);
  for (const auto& [robot, id] : history.NewestOf(address)) {
    if (!board->MayDo(address, robot, v1::OBSERVER_RIGHT_VIEW)) continue;
    if (board->HasNewer(robot, id)) continue;
    std::optional<HistoryRecord> record = history.Read(robot, id);
    if (record) board->OnPast(server, ListedOf(std::move(record->frame)), id);
  }
}

}  // namespace fovea::observer
