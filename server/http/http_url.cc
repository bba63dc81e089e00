#include "server/http/http_url.h"

#include <algorithm>
#include <stdexcept>

namespace fovea::server {

std::string HttpUrl::Authority() const {
  const bool is_ipv6 = host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + host + "]" : host) + (port == "80" ? "" : ":" + port);
}

std::string WithoutSecrets(const std::string& url) {
  const std::size_t query = url.find('?');
  const std::string shown = query == std::string::npos ? url : url.substr(0, query) + "?...";
  const std::size_t scheme = shown.find("//");
  const std::size_t host = scheme == std::string::npos ? 0 : scheme + 2;
  const std::size_t host_end = std::min(shown.find_first_of("/?", host), shown.size());
  const std::size_t at = shown.substr(0, host_end).rfind('@');
  if (at == std::string::npos || at < host) return shown;
  return shown.substr(0, host) + "..." + shown.substr(at);
}

HttpUrl ParseHttpUrl(const char* flag, const std::string& text) {
  const auto fail = [&] {
    throw std::invalid_argument(std::string(flag) + ": \"" + WithoutSecrets(text) +
                                "\" is not http://HOST[:PORT][/PATH][?QUERY]");
  };
  const std::string scheme = "http://";
  if (!text.starts_with(scheme)) fail();
  const std::size_t path_at = std::min(text.find_first_of("/?", scheme.size()), text.size());
  const std::string authority = text.substr(scheme.size(), path_at - scheme.size());
  HttpUrl url;
  if (path_at < text.size()) url.path = (text[path_at] == '?' ? "/" : "") + text.substr(path_at);
  const bool in_brackets = authority.starts_with('[');
  const std::size_t host_end =
      in_brackets ? authority.find(']') + 1 : std::min(authority.find(':'), authority.size());
  url.host = in_brackets ? authority.substr(1, host_end - 2) : authority.substr(0, host_end);
  const std::string rest = authority.substr(host_end);
  if (!rest.empty()) url.port = rest.substr(1);
  const bool digits = url.port.find_first_not_of("0123456789") == std::string::npos;
  const bool is_port = digits && !url.port.empty() && url.port.size() <= 5 &&
                       std::stoi(url.port) > 0 && std::stoi(url.port) <= 65535;
  if (url.host.empty() || !is_port || (!rest.empty() && rest.front() != ':')) fail();
  // Passwords and fragments would go nowhere.
  if (authority.find('@') != std::string::npos) fail();
  if (text.find_first_of(" \t\r\n#") != std::string::npos) fail();
  return url;
}

}  // namespace fovea::server
