// Certificates for tests, made when they are needed.
#pragma once

#include <memory>
#include <string>

struct evp_pkey_st;
struct x509_st;

namespace fovea::testing {

struct PemPair {
  std::string certificate, key;
};

// An authority that signs certificates, valid for a day.
class Authority {
 public:
  Authority();

  std::string Certificate() const;
  // For the given name, which is also its DNS name, and for 127.0.0.1.
  PemPair Issue(const std::string& name) const;

 private:
  std::shared_ptr<evp_pkey_st> key_;
  std::shared_ptr<x509_st> certificate_;
};

}  // namespace fovea::testing
