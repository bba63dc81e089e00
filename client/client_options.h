#pragma once

#if __cplusplus < 202002L
#error "the client library of fovea needs C++20: compile with -std=c++20"
#endif

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace fovea::client {

// PEM texts, not paths.
struct TlsOptions {
  // Whom to trust; empty = the authorities of this machine.
  std::string root_certificates;
  // What the server asks for with mutual TLS; both or none.
  std::string certificate_chain, private_key;
};

// Calls are tried again where that is safe and promises something: when the server was away, was
// stopping, or had too much to do and said when to come back.
struct RetryOptions {
  // 1 = never again. Where a server with too much to do says when to come back, a call goes on
  // until its deadline.
  int max_attempts = 5;
  // Before the second attempt; doubles with each, up to the maximum. The real wait is random
  // between half of it and all of it, so that robots do not come back all at once.
  std::chrono::milliseconds backoff{50}, max_backoff{2000};
};

struct ClientOptions {
  // Of a call that is given none.
  std::chrono::milliseconds timeout{10'000};
  RetryOptions retry = {};
  // Largest answer, 1 to 2047; the clouds of a 2048x1536 frame are 45 MiB.
  int max_answer_mib = 64;
  // Encrypts where it is given.
  std::optional<TlsOptions> tls = std::nullopt;
  // Both of printable ASCII characters, which is all that gRPC sends: others are refused.
  // Sent as `authorization: Bearer …`; empty = none. Without TLS anybody on the way can read it.
  std::string token = {};
  // The robot's name, sent as `fovea-robot`; empty = the server goes by the token, the certificate
  // or the host. Where a token or certificate says whose it is, that counts, and a name given
  // beside it is ignored.
  std::string robot = {};
};

// What finds a call again where others look. Of printable ASCII characters: others, and ids that
// are longer, are refused before anything is sent.
struct CallOptions {
  // 1 to 64 characters, sent as `fovea-request-id`: what the server calls the request in its log;
  // empty = a number that the server makes up. Errors have either (RpcError::request_id).
  std::string request_id = {};
  // W3C Trace Context, sent as `traceparent`: whose children the spans of the call's frames are,
  // where the server sends traces.
  std::string traceparent = {};
  // Of Detect: ends the call under way with CANCELLED as soon as that is asked for, from any
  // thread, and makes no other attempt. Streams have Cancel().
  std::stop_token stop = {};
};

// Whether a call can have this as a value of its metadata; gRPC ends the process where not.
bool IsPrintableAscii(std::string_view text);

}  // namespace fovea::client
