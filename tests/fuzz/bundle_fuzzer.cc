#include "client/bundle/bundle.h"
#include "client/bundle/readable_files.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::fuzzing {

void FuzzBundle(const std::uint8_t* data, std::size_t size) {
  constexpr bundle::ZipLimits kLimits{
      .max_entries = 32, .max_entry_bytes = 1 << 16, .max_total_bytes = 1 << 20};
  Try([&] {
    const bundle::Bundle bundle(std::string(Text(data, size)), kLimits);
    for (const std::string& name : bundle.names()) {
      Try([&] { bundle.AnswerOf(name); });
      Try([&] { bundle.ColorFileOf(name); });
      Try([&] { bundle.DepthFileOf(name); });
      Try([&] {
        const v1::Frame frame = bundle.RequestOf(name).frame();
        if (std::uint64_t{frame.depth().width()} * frame.depth().height() > kMaxPixels) {
          return;
        }
        bundle::ColorFile(frame.color());
        bundle::DepthFile(frame.depth());
      });
    }
  });
}

}  // namespace fovea::fuzzing
