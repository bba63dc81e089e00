// Tokens: their hashes and ends, and how callers show them.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "server/rpc/call_names.h"

namespace fovea::server {

// The SHA-256 of a token, in 64 hexadecimal digits.
std::string HashOfToken(std::string_view token);

// The same of `word`, the second of the line, in small letters. Throws std::invalid_argument unless
// it could be one. No error has a word of the line that may be a token: logs are read by many.
std::string ParseHash(const std::string& word, const std::string& line);

// Of a time such as 2027-01-31T12:00:00Z; throws std::invalid_argument for anything else. In whole
// seconds, since years beyond 2262 do not fit the nanoseconds of a time_point.
std::chrono::sys_seconds ParseExpiry(const std::string& text);

// "…" of the metadata `authorization: Bearer …`; the scheme in any case (RFC 9110, 11.1). Throws
// Unauthenticated where there is none.
std::string_view BearerTokenOf(const Metadata& metadata);

}  // namespace fovea::server
