#include "client/observer/tls_context.h"

#include <boost/asio/buffer.hpp>
#include <boost/system/error_code.hpp>
#include <stdexcept>

namespace fovea::observer {

std::optional<boost::asio::ssl::context> TlsContextOf(const PemFile& certificate,
                                                      const PemFile& key) {
  using boost::asio::ssl::context;
  if (certificate.text.empty()) return std::nullopt;
  context tls(context::tls_server);
  tls.set_options(context::default_workarounds | context::no_tlsv1 | context::no_tlsv1_1);
  // What OpenSSL says of both ("PEM lib") helps nobody.
  boost::system::error_code error;
  tls.use_certificate_chain(boost::asio::buffer(certificate.text), error);
  if (error) {
    throw std::runtime_error("--https-cert: " + certificate.path +
                             " holds no certificate chain in PEM");
  }
  tls.use_private_key(boost::asio::buffer(key.text), context::pem, error);
  if (error) {
    throw std::runtime_error("--https-key: " + key.path + " does not hold the key, in PEM, of " +
                             certificate.path);
  }
  return tls;
}

}  // namespace fovea::observer
