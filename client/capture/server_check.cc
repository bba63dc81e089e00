#include "client/capture/server_check.h"

#include <stdexcept>

#include "client/cli/explain.h"

namespace fovea::capture {
namespace {

// "0.1" of "0.1.5", "2" of "2.3.1".
std::string Generation(const std::string& version) {
  const std::size_t dot = version.find('.');
  if (version.substr(0, dot) != "0" || dot == std::string::npos) return version.substr(0, dot);
  return version.substr(0, version.find('.', dot + 1));
}

}  // namespace

void CheckVersions(const std::string& client, const std::string& server) {
  if (Generation(client) == Generation(server)) return;
  throw std::runtime_error("the server is fovea " + server + ", this client " + client +
                           ": update the older of the two (--any-version tries anyway)");
}

std::string CheckServer(const client::Client& client, const cli::ConnectionFlags& flags) {
  try {
    const std::string version = client.GetServerInfo().version();
    CheckVersions(FOVEA_VERSION, version);
    return "server " + flags.server + ", fovea " + version;
  } catch (const client::RpcError& error) {
    throw std::runtime_error(cli::Explain(error, flags, cli::DefaultLimit()));
  }
}

}  // namespace fovea::capture
