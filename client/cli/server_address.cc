#include "client/cli/server_address.h"

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

}  // namespace fovea::cli
