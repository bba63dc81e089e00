#include "server/logging/failed_handshakes.h"

#include <atomic>

namespace fovea::server {
namespace {

std::atomic<int> num_failed_handshakes = 0;

}  // namespace

void NoteFailedHandshake() { ++num_failed_handshakes; }

bool TakeFailedHandshake() {
  int number = num_failed_handshakes;
  while (number > 0) {
    if (num_failed_handshakes.compare_exchange_weak(number, number - 1)) return true;
  }
  return false;
}

}  // namespace fovea::server
