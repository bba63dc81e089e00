#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/observer/ask_routes.h"
#include "client/observer/history/history_routes.h"
#include "client/observer/http_types.h"
#include "client/observer/sessions.h"

namespace fovea::observer {

// Of what browsers reach: by this server, or perhaps by something in front of it.
enum class Encryption { kNone, kOwn, kPerhapsInFront };

// Who may ask for what, and what is answered. Thread-safe.
class Routes {
 public:
  // `hosts` are the names that browsers may know this server by (DNS rebinding), in letters of
  // either case.
  Routes(std::vector<ServerLink> servers, std::vector<std::string> hosts, Encryption encryption,
         const HistoryRoutes& history = HistoryRoutes());

  // Whether answering takes its time, as it asks the servers or reads the disk.
  static bool IsSlow(const HttpRequest& request);
  // Never throws for what is asked.
  HttpResponse Answer(const HttpRequest& request);
  // Whoever waits for a server's answer gets an error, from now on.
  void End() { asks_.End(); }

 private:
  HttpResponse Route(const HttpRequest& request);
  HttpResponse LogIn(const HttpRequest& request);
  HttpResponse LogOut(const HttpRequest& request, const Session& session);
  HttpResponse Who(const Session& session) const;
  HttpResponse Events(const HttpRequest& request, const Session& session) const;
  HttpResponse OfFrame(const HttpRequest& request, const Session& session) const;
  bool IsOwnHost(const std::string& host) const;
  bool IsOwnOrigin(const HttpRequest& request) const;
  std::string CookieOf(const HttpRequest& request, const std::string& id, bool ends) const;

  Sessions sessions_;
  const HistoryRoutes history_;
  AskRoutes asks_;
  std::vector<std::string> hosts_;  // in small letters
  const Encryption encryption_;
};

}  // namespace fovea::observer
