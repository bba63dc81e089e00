// Which of several servers a client asks. Knows no network and no clock.
//
// A client stays with one server, its home. When that has no room, others are asked for it; where
// none has any, the client asks for a place in line where the wait is least, and that is its home
// from then on. Until then nobody keeps a place for it: one that it does not take would hold up
// those behind it. The home changes as well where another one takes its calls twice in a row.
// Servers that are away are left alone for a while that doubles. Without a home, one is chosen by
// chance.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace fovea::client {

// Not thread-safe.
class ServerChoice {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ServerChoice(unsigned seed) : random_(seed) {}

  // By names that differ. Where these are others than before, the home is chosen anew.
  void SetServers(const std::vector<std::string>& names);
  std::size_t size() const { return servers_.size(); }

  // The home, chosen where there is none or it is away; whoever is back soonest where all are.
  // There must be a server.
  const std::string& Home(Clock::time_point now);

  // For `duration`, or a tenth of a second that doubles with each time in a row up to five seconds.
  void OnAway(const std::string& name, Clock::time_point now,
              std::optional<std::chrono::milliseconds> duration = std::nullopt);
  // It is the home from now on.
  void Move(const std::string& name) { home_ = name; }
  // Its connection ended, for whatever reason: it may be chosen again, like any other.
  void OnDisconnected(const std::string& name);
  void OnAnswered(const std::string& name);
  bool IsAway(const std::string& name, Clock::time_point now) const;
  bool AreAllAway(Clock::time_point now) const;

 private:
  friend class ServerRound;

  struct Server {
    std::string name;
    Clock::time_point away_until{};
    int failures = 0;
  };

  const Server* Find(const std::string& name) const;
  Server* Find(const std::string& name);
  // One of those that are not in `except`, at random; rather one that is not away, and only such
  // ones with `only_there`.
  std::string Another(const std::set<std::string>& except, bool only_there, Clock::time_point now);

  std::mt19937 random_;
  std::vector<Server> servers_;
  std::string home_;               // empty = none
  int num_elsewhere_ = 0;          // answers in a row that did not come from home
  bool has_asked_others_ = false;  // when a call got a place in line last
};

// One call's way around the servers: each is asked once at most for room, then one for a place in
// line.
class ServerRound {
 public:
  using Clock = ServerChoice::Clock;

  struct Ask {
    std::string server;
    bool only_if_room = false;  // else it is to keep a place in line
  };

  // `asks_others`: where the home has no room. Whoever has asked them and waits in line need not do
  // so again, and neither need the next call: it is enough that every second one does.
  ServerRound(ServerChoice& choice, bool asks_others)
      : choice_(choice), asks_others_(asks_others) {}

  // Whom to ask next; none once nobody is left that promises anything. Then one of the following.
  std::optional<Ask> Next(Clock::time_point now);
  void OnAnswered();
  void OnRefused(std::chrono::milliseconds retry_after);
  void OnAway(Clock::time_point now);

  // When whoever keeps a place says to come back; none where nobody does.
  const std::optional<std::chrono::milliseconds>& wait() const { return wait_; }

 private:
  Ask AskHome(const std::string& home, Clock::time_point now);
  Ask AskAnother(Clock::time_point now);

  // The most that one refusal makes others do, however many there are.
  static constexpr int kMaxOthers = 3;

  ServerChoice& choice_;
  const bool asks_others_;
  std::optional<Ask> last_;
  std::set<std::string> asked_;
  std::optional<std::chrono::milliseconds> wait_, least_wait_;  // in line; without a place
  std::string least_;                                           // who said that
  int num_others_ = 0;
};

}  // namespace fovea::client
