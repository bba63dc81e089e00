#pragma once

#include <string>

namespace fovea::server {

struct HttpUrl {
  std::string host;  // without brackets
  std::string port = "80";
  std::string path = "/";  // with the query

  // As the header Host has it: "collector:4318", "[::1]:4318", without the port where it is 80.
  std::string Authority() const;
};

// Where the text has a query, or a user with a password, "..." is in its place: for logs and
// errors.
std::string WithoutSecrets(const std::string& url);

// "http://HOST[:PORT][/PATH][?QUERY]". Throws std::invalid_argument that starts with `flag`.
HttpUrl ParseHttpUrl(const char* flag, const std::string& text);

}  // namespace fovea::server
