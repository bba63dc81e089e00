#include "client/cli/server_address.h"

#include <sstream>
#include <stdexcept>

#include "client/server_address.h"

namespace fovea::cli {

void CheckServerAddress(const std::string& address) {
  try {
    client::ParseServerAddresses(address);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--server: " + std::string(error.what()));
  }
}

std::vector<std::string> SplitServerAddresses(const std::string& addresses) {
  CheckServerAddress(addresses);
  std::vector<std::string> each;
  std::istringstream stream(addresses);
  for (std::string address; std::getline(stream, address, ',');) each.push_back(address);
  return each;
}

}  // namespace fovea::cli
