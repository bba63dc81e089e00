#include "server/access/tls_files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "server/access/file_to_read_again.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

std::string Read(const char* flag, const std::string& path) {
  RequireFileToReadAgain(flag, path);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  RequireField(file.good() && errno == 0, flag,
               "cannot read " + path + ": " + std::strerror(errno));
  return text.str();
}

// `parse`, whose complaints are about this file.
template <typename Parse>
auto Parsed(const char* flag, const std::string& path, Parse parse) {
  try {
    return parse();
  } catch (const std::invalid_argument& error) {
    FailField(flag, path + " " + error.what());
  }
}

std::shared_ptr<const ClientAuthority> AuthorityOf(const ServerOptions& options,
                                                   const TlsFiles& files) {
  const auto authorities = Parsed("--tls-client-ca", options.tls_client_ca,
                                  [&] { return CertificatesOf(files.client_ca); });
  return Parsed("--tls-crl", options.tls_crl, [&] {
    std::vector<RevocationList> lists;
    if (!options.tls_crl.empty()) lists = RevocationListsOf(files.revoked);
    return std::make_shared<const ClientAuthority>(authorities, lists);
  });
}

}  // namespace

bool TlsFiles::IsSameAs(const TlsFiles& other) const {
  return certificate == other.certificate && key == other.key && client_ca == other.client_ca &&
         revoked == other.revoked;
}

TlsFiles ReadTlsFiles(const ServerOptions& options) {
  TlsFiles files;
  files.certificate = Read("--tls-cert", options.tls_cert);
  files.key = Read("--tls-key", options.tls_key);
  const auto chain =
      Parsed("--tls-cert", options.tls_cert, [&] { return CertificatesOf(files.certificate); });
  files.leaf = chain.front();
  RequireField(!IsEncryptedKey(files.key), "--tls-key",
               options.tls_key +
                   " needs a password, which nobody gives the server: store the key "
                   "without (openssl pkey -in KEY -out KEY_WITHOUT)");
  const std::string why_not = WhyNoServerOf(files.leaf);
  RequireField(why_not.empty(), "--tls-cert",
               options.tls_cert + " is too weak, or nothing for servers: " + why_not);
  RequireField(IsKeyOf(files.key, chain), "--tls-key",
               options.tls_key + " does not hold the key, in PEM, of " + options.tls_cert);
  if (options.tls_client_ca.empty()) return files;
  files.client_ca = Read("--tls-client-ca", options.tls_client_ca);
  if (!options.tls_crl.empty()) files.revoked = Read("--tls-crl", options.tls_crl);
  files.authority = AuthorityOf(options, files);
  return files;
}

}  // namespace fovea::server
