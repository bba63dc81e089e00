// Certificates for tests, made when they are needed.
#pragma once

#include <memory>
#include <string>
#include <vector>

struct evp_pkey_st;
struct x509_st;

namespace fovea::testing {

constexpr long kDay_s = 24L * 3600;

struct PemPair {
  std::string certificate, key;
};

// An authority that signs certificates, valid for a day; itself for so many seconds.
class Authority {
 public:
  explicit Authority(long lifetime_s = kDay_s);

  std::string Certificate() const;
  // For the given name, which is also its DNS name, and for 127.0.0.1; good from so many seconds
  // from now on.
  PemPair Issue(const std::string& name, long start_s = -60) const;
  // The same with a key of RSA that is too short for TLS, or one that needs a password.
  PemPair IssueWithShortKey(const std::string& name) const;
  PemPair IssueWithPassword(const std::string& name) const;
  // The list of these certificates as revoked, whose next issue is due after so many seconds.
  std::string Revoke(const std::vector<std::string>& certificates, long due_s = 3600) const;

 private:
  std::string CertificateFor(const std::string& name, evp_pkey_st* key, long start_s) const;

  std::shared_ptr<evp_pkey_st> key_;
  std::shared_ptr<x509_st> certificate_;
};

}  // namespace fovea::testing
