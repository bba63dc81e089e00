// What is asked of fovea-observer, as text: METHOD TARGET, lines NAME: VALUE, an empty one, the
// body. Nothing of a robot that the session may not see is ever answered, and nothing ends in
// "500".
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>

#include "client/observer/ask_routes.h"
#include "client/observer/routes.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::observer {
namespace {

constexpr const char* kServer = "127.0.0.1:1";
constexpr const char* kSecret = "of-the-attic-alone";

HistoryRecord Record(const std::string& robot, const std::string& text) {
  HistoryRecord record{.header = {.robot = robot, .server = kServer, .version = "1"}};
  v1::WatchedFrame& frame = record.frame;
  frame.set_robot(robot);
  frame.set_frame_id(text);
  frame.set_picture("\xff\xd8" + text);
  frame.mutable_frame()->set_id(text);
  frame.mutable_depth()->set_data(text);
  frame.mutable_detections()->add_objects()->set_label(1);
  return record;
}

// One who may do all with kitchens, and nothing else.
v1::Observer Observer() {
  v1::Observer observer;
  observer.set_name("ann");
  observer.add_robots("kitchen-*");
  for (const v1::ObserverRight right : {v1::OBSERVER_RIGHT_VIEW, v1::OBSERVER_RIGHT_TRY,
                                        v1::OBSERVER_RIGHT_DOWNLOAD, v1::OBSERVER_RIGHT_PICK}) {
    observer.add_rights(right);
  }
  return observer;
}

struct World {
  World()
      : folder(std::filesystem::temp_directory_path() / ("fovea_routes_" + RandomName())),
        history(folder, {}),
        routes({}, {"localhost"}, Encryption::kNone),
        past(&history, &recorder),
        asks(past),
        feed({}, "token"),
        board({kServer}) {
    const std::chrono::system_clock::time_point start{std::chrono::seconds(1'700'000'000)};
    history.Add(Record("kitchen-1", "of-the-kitchen"), start);
    history.Add(Record("attic", kSecret), start);
    board.OnObserver(0, Observer());
  }
  ~World() { std::filesystem::remove_all(folder); }

  const std::filesystem::path folder;
  History history;
  Recorder recorder{{}, "token", 2, history};
  Routes routes;
  HistoryRoutes past;
  AskRoutes asks;
  Feed feed;
  Board board;
};

// As http_server.cc makes it of what Beast has parsed.
bool ParseRequest(const std::string& text, HttpRequest* request) {
  std::istringstream lines(text);
  std::string line, target;
  if (!std::getline(lines, line)) return false;
  std::istringstream words(line);
  words >> request->method >> target;
  while (std::getline(lines, line) && !line.empty()) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) return false;
    request->headers[line.substr(0, colon)] = line.substr(colon + 2);
  }
  request->body.assign(std::istreambuf_iterator<char>(lines), {});
  return ParseTarget(target, request);
}

void Check(const HttpResponse& response) {
  const bool is_fine = response.status >= 200 && response.status < 500 &&
                       response.body != nullptr &&
                       response.body->find(kSecret) == std::string::npos;
  if (!is_fine) std::abort();
}

void Ask(const std::string& text) {
  static World world;
  HttpRequest request;
  if (!ParseRequest(text, &request)) return;
  Check(world.routes.Answer(request));
  if (HistoryRoutes::IsOne(request.path)) Check(world.past.Answer(request, world.board));
  if (AskRoutes::IsOne(request.path)) Check(world.asks.Answer(request, world.feed));
}

}  // namespace
}  // namespace fovea::observer

namespace fovea::fuzzing {

void FuzzRoutes(const std::uint8_t* data, std::size_t size) {
  observer::Ask(std::string(Text(data, size)));
}

}  // namespace fovea::fuzzing
