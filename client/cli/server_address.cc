#include "client/cli/server_address.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>

namespace fovea::cli {
namespace {

bool IsOtherTarget(std::string_view address) {
  constexpr std::array<std::string_view, 5> kSchemes{
      "dns:", "ipv4:", "ipv6:", "unix:", "unix-abstract:"};
  return std::any_of(kSchemes.begin(), kSchemes.end(),
                     [&](std::string_view scheme) { return address.starts_with(scheme); });
}

bool IsHost(std::string_view host) {
  const bool in_brackets = host.starts_with('[') && host.ends_with(']') && host.size() > 2;
  return !host.empty() && host.find_first_of("/ ") == std::string_view::npos &&
         (in_brackets || host.find_first_of(":[]") == std::string_view::npos);
}

bool IsPort(std::string_view port) {
  const char* const last = port.data() + port.size();
  int number = 0;
  const auto [end, error] = std::from_chars(port.data(), last, number);
  return error == std::errc{} && end == last && number >= 1 && number <= 65535;
}

}  // namespace

void CheckServerAddress(const std::string& address) {
  if (IsOtherTarget(address)) return;
  const std::string_view text = address;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos && IsHost(text.substr(0, colon)) &&
      IsPort(text.substr(colon + 1))) {
    return;
  }
  throw std::invalid_argument("--server: \"" + address +
                              "\" is not HOST:PORT with a port of 1 to 65535, for example "
                              "127.0.0.1:50051 or [::1]:50051");
}

}  // namespace fovea::cli
