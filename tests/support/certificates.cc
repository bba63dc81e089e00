#include "tests/support/certificates.h"

#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rsa.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <random>

namespace fovea::testing {
namespace {

using Key = std::shared_ptr<EVP_PKEY>;
using Certificate = std::shared_ptr<X509>;

Key NewKey() { return {EVP_EC_gen("P-256"), EVP_PKEY_free}; }

void AddExtension(X509* certificate, int id, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
  X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, id, value.c_str());
  X509_add_ext(certificate, extension, -1);
  X509_EXTENSION_free(extension);
}

Certificate NewCertificate(const std::string& name, EVP_PKEY* key, long lifetime_s = kDay_s) {
  Certificate certificate(X509_new(), X509_free);
  X509_set_version(certificate.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()),
                   static_cast<int>(std::random_device{}() >> 1));
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -60);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), lifetime_s);
  X509_set_pubkey(certificate.get(), key);
  X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_ASC,
                             reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1, 0);
  return certificate;
}

template <typename Write>
std::string PemOf(Write write) {
  const std::unique_ptr<BIO, decltype(&BIO_free)> memory(BIO_new(BIO_s_mem()), BIO_free);
  write(memory.get());
  char* text = nullptr;
  const long size = BIO_get_mem_data(memory.get(), &text);
  return {text, static_cast<std::size_t>(size)};
}

std::string PemOfCertificate(X509* certificate) {
  return PemOf([=](BIO* out) { PEM_write_bio_X509(out, certificate); });
}

std::string PemOfKey(EVP_PKEY* key) {
  return PemOf(
      [=](BIO* out) { PEM_write_bio_PrivateKey(out, key, nullptr, nullptr, 0, nullptr, nullptr); });
}

}  // namespace

Authority::Authority(long lifetime_s)
    : key_(NewKey()), certificate_(NewCertificate("authority", key_.get(), lifetime_s)) {
  X509_set_issuer_name(certificate_.get(), X509_get_subject_name(certificate_.get()));
  AddExtension(certificate_.get(), NID_basic_constraints, "critical,CA:TRUE");
  AddExtension(certificate_.get(), NID_subject_key_identifier, "hash");
  X509_sign(certificate_.get(), key_.get(), EVP_sha256());
}

std::string Authority::Certificate() const { return PemOfCertificate(certificate_.get()); }

std::string Authority::CertificateFor(const std::string& name, EVP_PKEY* key, long start_s) const {
  const auto certificate = NewCertificate(name, key);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), start_s);
  X509_set_issuer_name(certificate.get(), X509_get_subject_name(certificate_.get()));
  AddExtension(certificate.get(), NID_subject_alt_name, "DNS:" + name + ",IP:127.0.0.1");
  X509_sign(certificate.get(), key_.get(), EVP_sha256());
  return PemOfCertificate(certificate.get());
}

PemPair Authority::Issue(const std::string& name, long start_s) const {
  const Key key = NewKey();
  return {CertificateFor(name, key.get(), start_s), PemOfKey(key.get())};
}

PemPair Authority::IssueWithShortKey(const std::string& name) const {
  const Key key(EVP_RSA_gen(512U), EVP_PKEY_free);
  return {CertificateFor(name, key.get(), -60), PemOfKey(key.get())};
}

PemPair Authority::IssueWithPassword(const std::string& name) const {
  const Key key = NewKey();
  return {CertificateFor(name, key.get(), -60), PemOf([&](BIO* out) {
            PEM_write_bio_PKCS8PrivateKey(out, key.get(), EVP_aes_256_cbc(), "secret", 6, nullptr,
                                          nullptr);
          })};
}

std::string Authority::Revoke(const std::vector<std::string>& certificates, long due_s) const {
  const std::unique_ptr<X509_CRL, decltype(&X509_CRL_free)> list(X509_CRL_new(), X509_CRL_free);
  const std::unique_ptr<ASN1_TIME, decltype(&ASN1_TIME_free)> time(ASN1_TIME_new(), ASN1_TIME_free);
  X509_CRL_set_version(list.get(), X509_CRL_VERSION_2);
  X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(certificate_.get()));
  X509_gmtime_adj(time.get(), std::min(-60L, due_s - 60));
  X509_CRL_set1_lastUpdate(list.get(), time.get());
  for (const std::string& pem : certificates) {
    const std::unique_ptr<BIO, decltype(&BIO_free)> reader(
        BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())), BIO_free);
    const std::shared_ptr<X509> certificate(
        PEM_read_bio_X509(reader.get(), nullptr, nullptr, nullptr), X509_free);
    X509_REVOKED* entry = X509_REVOKED_new();
    X509_REVOKED_set_serialNumber(entry, X509_get_serialNumber(certificate.get()));
    X509_REVOKED_set_revocationDate(entry, time.get());
    X509_CRL_add0_revoked(list.get(), entry);
  }
  X509_gmtime_adj(time.get(), due_s);
  X509_CRL_set1_nextUpdate(list.get(), time.get());
  X509_CRL_sign(list.get(), key_.get(), EVP_sha256());
  return PemOf([&](BIO* out) { PEM_write_bio_X509_CRL(out, list.get()); });
}

}  // namespace fovea::testing
