#include "client/observer/assets.h"

#include <zlib.h>

#include <map>
#include <stdexcept>
#include <string_view>

// The bytes of page/dist/FILE between two symbols.
#define FOVEA_EMBED(name, file)                                               \
  __asm__(".section .rodata\n.global fovea_page_" #name "\nfovea_page_" #name \
          ":\n.incbin \"" FOVEA_PAGE "/" file "\"\n.global fovea_page_" #name \
          "_end\nfovea_page_" #name "_end:\n.byte 0\n.previous\n");           \
  extern "C" const char fovea_page_##name[], fovea_page_##name##_end[]

FOVEA_EMBED(html, "index.html");
FOVEA_EMBED(css, "page.css");
FOVEA_EMBED(js, "page.js");
FOVEA_EMBED(icon, "icon.svg");
FOVEA_EMBED(licenses, "licenses.txt");

namespace fovea::observer {
namespace {

std::shared_ptr<const std::string> Gzip(std::string_view text) {
  constexpr int kGzipWindow = 15 + 16, kMemory = 9;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib cannot start");
  }
  std::string input(text), output(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  const int result = deflate(&stream, Z_FINISH);
  output.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("zlib failed");
  return std::make_shared<const std::string>(std::move(output));
}

std::map<std::string, Asset> MakeAssets() {
  const auto asset = [](const char* type, const char* begin, const char* end) {
    return Asset{type, Gzip({begin, static_cast<std::size_t>(end - begin)})};
  };
  return {{"/index.html", asset("text/html; charset=utf-8", fovea_page_html, fovea_page_html_end)},
          {"/page.css", asset("text/css; charset=utf-8", fovea_page_css, fovea_page_css_end)},
          {"/page.js", asset("text/javascript; charset=utf-8", fovea_page_js, fovea_page_js_end)},
          {"/icon.svg", asset("image/svg+xml", fovea_page_icon, fovea_page_icon_end)},
          {"/licenses.txt",
           asset("text/plain; charset=utf-8", fovea_page_licenses, fovea_page_licenses_end)}};
}

}  // namespace

std::optional<Asset> FindAsset(const std::string& path) {
  static const std::map<std::string, Asset> kAssets = MakeAssets();
  const auto found = kAssets.find(path);
  return found == kAssets.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace fovea::observer
