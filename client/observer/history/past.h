// What the list of robots has of those that have sent nothing since somebody logged in.
#pragma once

#include <cstddef>
#include <string>

#include "client/observer/board.h"
#include "client/observer/history/history.h"

namespace fovea::observer {

// The picture that was shown, or the file that was sent where that was one that browsers show.
const std::string& PictureOf(const v1::WatchedFrame& frame);

// Puts the newest frame that the history has of each robot of a server on the board, where who
// watches may see that robot and the board has nothing newer. Reads the disk.
void ShowPast(const History& history, std::size_t server, Board* board);

}  // namespace fovea::observer
