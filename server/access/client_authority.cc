#include "server/access/client_authority.h"

#include <openssl/err.h>
#include <openssl/x509_vfy.h>

#include <algorithm>
#include <utility>

#include "server/access/wall_clock.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxRemembered = 1024;

// A list is better late than none: it goes on being heeded.
int Heed(int ok, X509_STORE_CTX* context) {
  const int error = X509_STORE_CTX_get_error(context);
  const bool late = error == X509_V_ERR_CRL_HAS_EXPIRED || error == X509_V_ERR_CRL_NOT_YET_VALID;
  if (ok == 0 && late) X509_STORE_CTX_set_error(context, X509_V_OK);
  return late ? 1 : ok;
}

bool IsSignedBy(X509_CRL* list, X509* authority) {
  return X509_NAME_cmp(X509_CRL_get_issuer(list), X509_get_subject_name(authority)) == 0 &&
         X509_CRL_verify(list, X509_get0_pubkey(authority)) == 1;
}

bool SignedItself(X509* authority) {
  return X509_NAME_cmp(X509_get_issuer_name(authority), X509_get_subject_name(authority)) == 0;
}

void RequireToBelongTogether(const std::vector<Certificate>& authorities,
                             const std::vector<RevocationList>& lists) {
  for (const RevocationList& list : lists) {
    const bool known = std::ranges::any_of(authorities, [&](const Certificate& authority) {
      return IsSignedBy(list.get(), authority.get());
    });
    if (!known) {
      throw std::invalid_argument("the list of " + NameOf(*X509_CRL_get_issuer(list.get())) +
                                  " is signed by no authority of --tls-client-ca");
    }
  }
  for (const Certificate& authority : authorities) {
    const bool listed = std::ranges::any_of(
        lists, [&](const RevocationList& list) { return IsSignedBy(list.get(), authority.get()); });
    if (!listed && SignedItself(authority.get())) {
      throw std::invalid_argument("holds no list of " + SubjectOf(*authority) +
                                  ", an authority of --tls-client-ca");
    }
  }
}

// When the first certificate of the chain that was found expires.
std::chrono::sys_seconds ExpiryOfChain(const X509_STORE_CTX& context) {
  std::chrono::sys_seconds first = std::chrono::sys_seconds::max();
  STACK_OF(X509)* const chain = X509_STORE_CTX_get0_chain(&context);
  for (int i = 0; i < sk_X509_num(chain); ++i) {
    first = std::min(first, ExpiryOf(*sk_X509_value(chain, i)));
  }
  return first;
}

// With the strictness of gRPC's handshake.
std::shared_ptr<X509_STORE> StoreOf(const std::vector<Certificate>& authorities,
                                    const std::vector<RevocationList>& lists) {
  std::shared_ptr<X509_STORE> store(X509_STORE_new(), X509_STORE_free);
  for (const Certificate& authority : authorities) {
    X509_STORE_add_cert(store.get(), authority.get());
  }
  for (const RevocationList& list : lists) X509_STORE_add_crl(store.get(), list.get());
  unsigned long flags = X509_V_FLAG_PARTIAL_CHAIN | X509_V_FLAG_TRUSTED_FIRST;
  if (!lists.empty()) flags |= X509_V_FLAG_CRL_CHECK;
  X509_STORE_set_flags(store.get(), flags);
  X509_STORE_set_verify_cb(store.get(), Heed);
  return store;
}

std::string Explain(int error) {
  if (error == X509_V_ERR_CERT_REVOKED) return "was revoked";
  if (error == X509_V_ERR_CERT_HAS_EXPIRED) return "has expired";
  if (error == X509_V_ERR_UNABLE_TO_GET_CRL) return "is of an authority without a revocation list";
  return std::string("is not good (any more): ") + X509_verify_cert_error_string(error);
}

}  // namespace

ClientAuthority::ClientAuthority(std::vector<Certificate> authorities,
                                 std::vector<RevocationList> lists)
    : authorities_(std::move(authorities)),
      lists_(std::move(lists)),
      store_(StoreOf(authorities_, lists_)) {
  if (!lists_.empty()) RequireToBelongTogether(authorities_, lists_);
}

std::chrono::sys_seconds ClientAuthority::GoodUntil(const std::string& certificate,
                                                    const std::string& chain) const {
  const std::chrono::sys_seconds now = NowInSeconds();
  {
    const std::lock_guard lock(mutex_);
    const auto known = good_.find(certificate);
    if (known != good_.end() && now < known->second) return known->second;
  }
  const std::chrono::sys_seconds until = Verify(certificate, chain);
  const std::lock_guard lock(mutex_);
  if (good_.size() >= kMaxRemembered) good_.clear();
  good_.insert_or_assign(certificate, until);
  return until;
}

std::chrono::sys_seconds ClientAuthority::Verify(const std::string& certificate,
                                                 const std::string& chain) const {
  const Certificate leaf = CertificatesOf(certificate).front();
  std::vector<Certificate> others;
  if (!chain.empty()) others = CertificatesOf(chain);
  const std::unique_ptr<STACK_OF(X509), void (*)(STACK_OF(X509)*)> untrusted(
      sk_X509_new_null(), [](STACK_OF(X509) * stack) { sk_X509_free(stack); });
  for (const Certificate& other : others) sk_X509_push(untrusted.get(), other.get());
  const std::unique_ptr<X509_STORE_CTX, decltype(&X509_STORE_CTX_free)> context(
      X509_STORE_CTX_new(), X509_STORE_CTX_free);
  X509_STORE_CTX_init(context.get(), store_.get(), leaf.get(), untrusted.get());
  X509_STORE_CTX_set_default(context.get(), "ssl_client");
  const bool good = X509_verify_cert(context.get()) == 1;
  ERR_clear_error();
  if (!good) {
    throw std::runtime_error("the client certificate " +
                             Explain(X509_STORE_CTX_get_error(context.get())));
  }
  return ExpiryOfChain(*context);
}

std::vector<std::string> ClientAuthority::OverdueLists(std::chrono::sys_seconds now) const {
  std::vector<std::string> overdue;
  for (const RevocationList& list : lists_) {
    const ASN1_TIME* next = X509_CRL_get0_nextUpdate(list.get());
    if (next == nullptr || now < TimeOf(*next)) continue;
    overdue.push_back("the list of " + NameOf(*X509_CRL_get_issuer(list.get())) +
                      " should have been replaced by " + TextOf(TimeOf(*next)));
  }
  return overdue;
}

}  // namespace fovea::server
