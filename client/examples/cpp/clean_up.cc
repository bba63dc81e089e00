// Cleans up a floor: takes what is likeliest to hold, of what nothing stands on, and looks again.
// `fovea-clean-up` simulates the robot: it writes what the camera sees to the standard input, a
// request a line, and does the grasps that come back (docs/clean_up.md).
#include <google/protobuf/util/json_util.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "fovea/client/client.h"

using google::protobuf::util::JsonStringToMessage;
using google::protobuf::util::MessageToJsonString;

using namespace fovea::v1;  // NOLINT(google-build-using-namespace): one program

double Distance(const Vector3& a, const Vector3& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
}

// Half as much for each time that it was tried, less for places near it: what is still there did
// not hold.
double Chance(const Grasp& grasp, const std::vector<Grasp>& tried) {
  double chance = grasp.probability();
  for (const Grasp& before : tried) {
    const double apart = Distance(grasp.tool_center_point(), before.tool_center_point());
    chance *= 1 - 0.5 * std::exp(-apart / 0.05);
  }
  return chance;
}

void Tell(const char* what, const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions as_in_the_contract;
  as_in_the_contract.preserve_proto_field_names = true;
  std::string json;
  if (!MessageToJsonString(message, &json, as_in_the_contract).ok()) {
    throw std::runtime_error("an answer has no JSON");
  }
  std::cout << "{\"" << what << "\":" << json << '}' << std::endl;
}

int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("give HOST:PORT; requests come by standard input");
  const fovea::client::Client client(argv[1]);
  std::vector<Grasp> tried;
  for (std::string line; std::getline(std::cin, line);) {
    DetectRequest request;
    if (!JsonStringToMessage(line, &request).ok()) throw std::invalid_argument("no request");
    const Detections found = client.Detect(request).detections();

    Grasp best;
    for (const Object& object : found.objects()) {
      if (object.blocked_by_size() > 0) continue;
      for (const Grasp& grasp : object.grasps()) {
        if (Chance(grasp, tried) > Chance(best, tried)) best = grasp;
      }
    }
    const bool is_worth_it = Chance(best, tried) > 0.01;
    Tell(is_worth_it ? "grasp" : "left",
         is_worth_it ? static_cast<const google::protobuf::Message&>(best) : found);
    tried.push_back(best);
  }
} catch (const std::exception& error) {
  std::cerr << "clean_up: " << error.what() << '\n';
  return 1;
}
