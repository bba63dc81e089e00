#pragma once

#include <boost/asio/ssl/context.hpp>
#include <optional>

#include "client/observer/http_server.h"

namespace fovea::observer {

// None where there is no certificate. Throws std::runtime_error that names flag and file where they
// hold something else.
std::optional<boost::asio::ssl::context> TlsContextOf(const PemFile& certificate,
                                                      const PemFile& key);

}  // namespace fovea::observer
