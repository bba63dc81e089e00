#include "client/bundle/bundle.h"
#include "client/bundle/readable_files.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr bundle::ZipLimits kLimits{
      .max_entries = 32, .max_entry_bytes = 1 << 16, .max_total_bytes = 1 << 20};
  fuzzing::Try([&] {
    const bundle::Bundle bundle(std::string(fuzzing::Text(data, size)), kLimits);
    for (const std::string& name : bundle.names()) {
      fuzzing::Try([&] { bundle.AnswerOf(name); });
      fuzzing::Try([&] { bundle.ColorFileOf(name); });
      fuzzing::Try([&] { bundle.DepthFileOf(name); });
      fuzzing::Try([&] {
        const v1::Frame frame = bundle.RequestOf(name).frame();
        if (std::uint64_t{frame.depth().width()} * frame.depth().height() > fuzzing::kMaxPixels) {
          return;
        }
        bundle::ColorFile(frame.color());
        bundle::DepthFile(frame.depth());
      });
    }
  });
  return 0;
}
