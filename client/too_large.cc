#include "client/too_large.h"

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>

namespace fovea::client {
namespace {

std::string Mebibytes(std::uint64_t bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f MiB", static_cast<double>(bytes) / (1 << 20));
  return text.data();
}

}  // namespace

// The text is that of gRPC 1.51; others stay as they are. A frame is taken for an answer where the
// server takes exactly as much as this client.
grpc::Status SayingWhatIsTooLarge(const grpc::Status& status, int max_answer_mib) {
  std::uint64_t size = 0, most = 0;
  const std::string text = status.error_message();
  const std::size_t at = text.find("larger than max (");
  if (at == std::string::npos ||
      std::sscanf(text.c_str() + at, "larger than max (%" SCNu64 " vs. %" SCNu64 ")", &size,
                  &most) != 2) {
    return status;
  }
  const bool is_answer = most == static_cast<std::uint64_t>(max_answer_mib) << 20;
  return {status.error_code(),
          is_answer ? "the answer is " + Mebibytes(size) + ", this client takes " +
                          Mebibytes(most) + " (max_answer_mib)"
                    : "the frame is " + Mebibytes(size) + ", the server takes " + Mebibytes(most) +
                          " (--max-message-mib): send a smaller image, or png, jpeg or zstd",
          status.error_details()};
}

}  // namespace fovea::client
