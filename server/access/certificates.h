// Certificates, keys and revocation lists in PEM, by OpenSSL.
#pragma once

#include <openssl/x509.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace fovea::server {

using Certificate = std::shared_ptr<X509>;
using RevocationList = std::shared_ptr<X509_CRL>;

// All that the text holds, in its order; blocks of other kinds are skipped. Throws
// std::invalid_argument where there is none ("holds no certificate in PEM", "holds no revocation
// list in PEM") or one is damaged.
std::vector<Certificate> CertificatesOf(const std::string& pem);
std::vector<RevocationList> RevocationListsOf(const std::string& pem);

// Whether the text holds a key in PEM that needs a password.
bool IsEncryptedKey(const std::string& key_pem);

// Whether the text holds, unencrypted, the key of the first of these certificates.
bool IsKeyOf(const std::string& key_pem, const std::vector<Certificate>& chain);

// Why OpenSSL makes no server of this certificate ("ee key too small"); empty where it does.
std::string WhyNoServerOf(const Certificate& certificate);

// In whole seconds, since times beyond 2262 do not fit the nanoseconds of a time_point.
std::chrono::sys_seconds StartOf(const X509& certificate);
std::chrono::sys_seconds ExpiryOf(const X509& certificate);
std::chrono::sys_seconds TimeOf(const ASN1_TIME& time);

// "CN=server,O=Fovea" and "0x1F4A…".
std::string SubjectOf(const X509& certificate);
std::string NameOf(const X509_NAME& name);
std::string SerialOf(const X509& certificate);

// "2027-01-31T12:00:00Z".
std::string TextOf(std::chrono::sys_seconds time);

}  // namespace fovea::server
