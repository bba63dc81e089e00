#include "server/access/certificates.h"

#include <openssl/asn1.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>

#include <ctime>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace fovea::server {
namespace {

using Bio = std::unique_ptr<BIO, decltype(&BIO_free)>;

Bio Reader(const std::string& text) {
  return {BIO_new_mem_buf(text.data(), static_cast<int>(text.size())), BIO_free};
}

// All things that `read` finds, one after the other.
template <typename Thing>
std::vector<std::shared_ptr<Thing>> ReadAll(const std::string& pem,
                                            Thing* (*read)(BIO*, Thing**, pem_password_cb*, void*),
                                            void (*free)(Thing*), const std::string& name) {
  const Bio reader = Reader(pem);
  std::vector<std::shared_ptr<Thing>> things;
  ERR_clear_error();
  while (Thing* thing = read(reader.get(), nullptr, nullptr, nullptr))
    things.emplace_back(thing, free);
  const bool at_end = ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE;
  ERR_clear_error();
  if (!at_end) throw std::invalid_argument("holds a damaged " + name);
  if (things.empty()) throw std::invalid_argument("holds no " + name + " in PEM");
  return things;
}

}  // namespace

std::vector<Certificate> CertificatesOf(const std::string& pem) {
  return ReadAll<X509>(pem, PEM_read_bio_X509, X509_free, "certificate");
}

std::vector<RevocationList> RevocationListsOf(const std::string& pem) {
  return ReadAll<X509_CRL>(pem, PEM_read_bio_X509_CRL, X509_CRL_free, "revocation list");
}

bool IsEncryptedKey(const std::string& key_pem) {
  // As PKCS #8 has it, and as keys of one kind did before.
  return key_pem.find("-----BEGIN ENCRYPTED PRIVATE KEY-----") != std::string::npos ||
         key_pem.find("Proc-Type: 4,ENCRYPTED") != std::string::npos;
}

bool IsKeyOf(const std::string& key_pem, const std::vector<Certificate>& chain) {
  char no_password[] = "";  // else OpenSSL asks the terminal for one
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(
      PEM_read_bio_PrivateKey(Reader(key_pem).get(), nullptr, nullptr, no_password), EVP_PKEY_free);
  const bool fits = key != nullptr && X509_check_private_key(chain.front().get(), key.get()) == 1;
  ERR_clear_error();
  return fits;
}

std::string WhyNoServerOf(const Certificate& certificate) {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(SSL_CTX_new(TLS_server_method()),
                                                                  SSL_CTX_free);
  ERR_clear_error();
  if (SSL_CTX_use_certificate(context.get(), certificate.get()) == 1) return {};
  const char* const reason = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return reason != nullptr ? reason : "OpenSSL does not say why";
}

std::chrono::sys_seconds TimeOf(const ASN1_TIME& time) {
  std::tm parts{};
  ASN1_TIME_to_tm(&time, &parts);
  return std::chrono::sys_seconds(std::chrono::seconds(timegm(&parts)));
}

std::chrono::sys_seconds StartOf(const X509& certificate) {
  return TimeOf(*X509_get0_notBefore(&certificate));
}

std::chrono::sys_seconds ExpiryOf(const X509& certificate) {
  return TimeOf(*X509_get0_notAfter(&certificate));
}

std::string NameOf(const X509_NAME& name) {
  const Bio text(BIO_new(BIO_s_mem()), BIO_free);
  X509_NAME_print_ex(text.get(), &name, 0, XN_FLAG_RFC2253);
  char* begin = nullptr;
  const long size = BIO_get_mem_data(text.get(), &begin);
  return {begin, static_cast<std::size_t>(size)};
}

std::string SubjectOf(const X509& certificate) {
  return NameOf(*X509_get_subject_name(&certificate));
}

std::string SerialOf(const X509& certificate) {
  const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(
      ASN1_INTEGER_to_BN(X509_get0_serialNumber(&certificate), nullptr), BN_free);
  const std::unique_ptr<char, void (*)(char*)> digits(BN_bn2hex(number.get()),
                                                      [](char* text) { OPENSSL_free(text); });
  return std::string("0x") + digits.get();
}

std::string TextOf(std::chrono::sys_seconds time) {
  const std::time_t seconds = time.time_since_epoch().count();
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%dT%H:%M:%SZ");
  return text.str();
}

}  // namespace fovea::server
