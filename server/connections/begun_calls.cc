#include "server/connections/begun_calls.h"

#include <grpc/grpc.h>
#include <grpc/support/alloc.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fovea::server {
namespace {

using nlohmann::json;

// What gRPC counts anyway, as its channelz service would tell it. Numbers are strings there.
json Channelz(char* text) {
  const std::unique_ptr<char, void (*)(void*)> owned(text, gpr_free);
  if (!owned) throw std::runtime_error("gRPC does not count calls");
  return json::parse(owned.get());
}

std::uint64_t Number(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? 0 : std::stoull(found->get<std::string>());
}

// All of a list that comes in pages; `ask` gets the first number wanted.
template <typename Ask>
json AllPages(const char* list, const char* id, Ask&& ask) {
  json all = json::array();
  for (std::uint64_t next = 0;;) {
    const json page = Channelz(ask(static_cast<std::intptr_t>(next)));
    for (const json& one : page.value(list, json::array())) {
      next = Number(one.contains("ref") ? one["ref"] : one, id) + 1;
      all.push_back(one);
    }
    if (page.value("end", false) || !page.contains(list)) return all;
  }
}

json Servers() { return AllPages("server", "serverId", grpc_channelz_get_servers); }

json SocketsOf(const json& server) {
  const auto id = static_cast<std::intptr_t>(Number(server["ref"], "serverId"));
  return AllPages("socketRef", "socketId", [id](std::intptr_t first) {
    return grpc_channelz_get_server_sockets(id, first, /*max_results=*/0);
  });
}

}  // namespace

std::uint64_t NumBegunCalls() {
  std::uint64_t number = 0;
  for (const json& server : Servers()) {
    number += Number(server.value("data", json::object()), "callsStarted");
  }
  return number;
}

std::vector<CallsOfConnection> BegunCallsByConnection() {
  std::vector<CallsOfConnection> calls;
  for (const json& server : Servers()) {
    for (const json& socket : SocketsOf(server)) {
      const std::string name = socket.value("name", "");
      char* text = grpc_channelz_get_socket(static_cast<std::intptr_t>(Number(socket, "socketId")));
      if (text == nullptr) continue;  // it has just been closed
      const json told = Channelz(text);
      calls.push_back(
          {.peer = name.substr(name.rfind(' ') + 1),
           .begun = Number(told["socket"].value("data", json::object()), "streamsStarted")});
    }
  }
  return calls;
}

}  // namespace fovea::server
