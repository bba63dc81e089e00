#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "client/observer/board.h"
#include "client/observer/history/history.h"
#include "client/observer/history/recorder.h"
#include "client/observer/http_types.h"

namespace fovea::observer {

// What of the history is answered: of it each session sees what its own token lets it see. Thread-
// safe.
class HistoryRoutes {
 public:
  // Null: there is none. Both must outlive it.
  explicit HistoryRoutes(const History* history = nullptr, const Recorder* recorder = nullptr)
      : history_(history), recorder_(recorder) {}

  static bool IsOne(const std::string& path);
  HttpResponse Answer(const HttpRequest& request, const Board& board) const;

  const History* history() const { return history_; }

  // {"minutes": …, "problem": …} as JSON, null where there is no history.
  std::string About() const;

  // A frame that the session may see and, beyond that, has this right over; none else.
  std::optional<HistoryRecord> Find(const std::string& robot, std::uint64_t id, const Board& board,
                                    v1::ObserverRight right) const;

 private:
  HttpResponse List(const std::string& robot, const Board& board) const;
  HttpResponse OfFrame(const HttpRequest& request, const Board& board) const;
  HttpResponse Bundle(const HttpRequest& request, const Board& board) const;

  const History* history_;
  const Recorder* recorder_;
  // Whether a bundle is made or sent now, as each takes memory. Of all copies of this.
  std::shared_ptr<std::atomic<bool>> bundle_is_out_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace fovea::observer
