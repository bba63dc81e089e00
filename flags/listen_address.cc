#include "flags/listen_address.h"

#include <charconv>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace fovea::flags {

void RequireListenAddress(const char* flag, const std::string& listen) {
  const std::size_t colon = listen.rfind(':');
  const std::string_view port =
      colon == std::string::npos ? std::string_view{} : std::string_view(listen).substr(colon + 1);
  int number = -1;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
  const bool is_port =
      error == std::errc{} && end == port.data() + port.size() && number >= 0 && number <= 65535;
  if (colon == std::string::npos || colon == 0 || !is_port) {
    throw std::invalid_argument(std::string(flag) + ": \"" + listen +
                                "\" is not HOST:PORT with a port of 0 to 65535");
  }
}

}  // namespace fovea::flags
