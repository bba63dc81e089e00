// Between what goes over the wire and what the routes know.
#pragma once

#include <boost/beast/http.hpp>
#include <string>

#include "client/observer/http_types.h"

namespace fovea::observer {

// The status line and fields. A stream of events ends with its connection.
std::string HeadOf(const HttpResponse& response, unsigned version, bool keep_alive);

// `is_good` = its target can be understood.
HttpRequest RequestOf(const boost::beast::http::request<boost::beast::http::string_body>& message,
                      bool* is_good);

}  // namespace fovea::observer
