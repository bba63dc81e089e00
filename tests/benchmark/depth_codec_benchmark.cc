// What it takes to pack the depth of a frame without loss, and to unpack it; how many bytes it has.
#include <benchmark/benchmark.h>
#include <zstd.h>

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "client/rvl.h"
#include "server/codec/png.h"
#include "server/codec/rvl.h"
#include "server/codec/zstd.h"
#include "tests/benchmark/frames.h"

namespace fovea {
namespace {

std::string ToZstd(const void* bytes, std::size_t size) {
  std::string packed(ZSTD_compressBound(size), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes, size, 1));
  return packed;
}

struct Png {
  static std::string Pack(const cv::Mat& depth) {
    std::vector<unsigned char> file;
    cv::imencode(".png", depth, file, {cv::IMWRITE_PNG_COMPRESSION, 1});
    return {file.begin(), file.end()};
  }
  static cv::Mat Unpack(const std::string& file, const cv::Size& size) {
    return server::DecodePngGray16(file, {.max_pixels = static_cast<std::uint64_t>(size.area())});
  }
};

struct Zstd {
  static std::string Pack(const cv::Mat& depth) {
    return ToZstd(depth.data, depth.total() * depth.elemSize());
  }
  static std::string Unpack(const std::string& packed, const cv::Size& size) {
    return server::DecompressZstd(packed, 2 * static_cast<std::size_t>(size.area()));
  }
};

struct Rvl {
  static std::string Pack(const cv::Mat& depth) {
    return client::EncodeRvl(depth.ptr<std::uint16_t>(), depth.total());
  }
  static cv::Mat Unpack(const std::string& codes, const cv::Size& size) {
    return server::DecodeRvl(codes, size.width, size.height);
  }
};

struct RvlZstd {
  static std::string Pack(const cv::Mat& depth) {
    const std::string codes = Rvl::Pack(depth);
    return ToZstd(codes.data(), codes.size());
  }
  static cv::Mat Unpack(const std::string& packed, const cv::Size& size) {
    const std::size_t most = server::MaxRvlBytes(static_cast<std::size_t>(size.area()));
    return Rvl::Unpack(server::DecompressZstdUpTo(packed, most), size);
  }
};

cv::Mat Millimetres(const benchmark::State& state) {
  const cv::Mat depth_m = ReadDepth(FrameNames()[static_cast<std::size_t>(state.range(0))]);
  cv::Mat known = depth_m.clone(), depth;
  cv::patchNaNs(known, 0);
  known.convertTo(depth, CV_16U, 1000);
  return depth;
}

template <typename Codec>
void PackDepth(benchmark::State& state) {
  const cv::Mat depth = Millimetres(state);
  for (auto _ : state) benchmark::DoNotOptimize(Codec::Pack(depth));
  state.counters["bytes"] = static_cast<double>(Codec::Pack(depth).size());
  state.SetLabel(SourceOf(FrameNames()[static_cast<std::size_t>(state.range(0))]));
}

template <typename Codec>
void UnpackDepth(benchmark::State& state) {
  const cv::Mat depth = Millimetres(state);
  const std::string packed = Codec::Pack(depth);
  for (auto _ : state) benchmark::DoNotOptimize(Codec::Unpack(packed, depth.size()));
}

BENCHMARK(PackDepth<Png>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(PackDepth<Zstd>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(PackDepth<Rvl>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(PackDepth<RvlZstd>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(UnpackDepth<Png>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(UnpackDepth<Zstd>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(UnpackDepth<Rvl>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(UnpackDepth<RvlZstd>)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fovea
