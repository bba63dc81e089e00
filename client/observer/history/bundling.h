// Frames of the history as one file for a bug report.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/observer/history/history.h"
#include "client/observer/http_types.h"

namespace fovea::observer {

// In microseconds: the frame nearest to `at`, and those of so much time before and after it.
struct Moment {
  std::uint64_t at = 0, before = 0, after = 0;
};

// Of ?at=…&before=SECONDS&after=SECONDS; the latter are 0 where they are missing. None where that
// is malformed.
std::optional<Moment> MomentOf(const HttpRequest& request);

struct BundleFile {
  std::string name = {};
  std::chrono::milliseconds answered_at{};  // since 1970, of the frame nearest to the moment
  std::string bytes = {};
};

// Those nearest to the moment where all would be too many: 64 frames, or 32 MiB. `entries` are what
// may be given away, oldest first. None where there is nothing. Takes several times the memory of
// what it returns. Throws std::runtime_error.
std::optional<BundleFile> BundleOf(const History& history, const std::string& robot,
                                   const std::vector<History::Entry>& entries,
                                   const Moment& moment);

}  // namespace fovea::observer
