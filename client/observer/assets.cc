#include "client/observer/assets.h"

#include <map>

// The bytes of page/dist/FILE, which the build has compressed, between two symbols.
#define FOVEA_EMBED(name, file)                                                  \
  __asm__(".section .rodata\n.global fovea_page_" #name "\nfovea_page_" #name    \
          ":\n.incbin \"" FOVEA_PAGE "/" file ".gz\"\n.global fovea_page_" #name \
          "_end\nfovea_page_" #name "_end:\n.byte 0\n.previous\n");              \
  extern "C" const char fovea_page_##name[], fovea_page_##name##_end[]

FOVEA_EMBED(html, "index.html");
FOVEA_EMBED(css, "page.css");
FOVEA_EMBED(js, "page.js");
FOVEA_EMBED(icon, "icon.svg");
FOVEA_EMBED(licenses, "licenses.txt");

namespace fovea::observer {
namespace {

std::map<std::string, Asset> MakeAssets() {
  const auto asset = [](const char* type, const char* begin, const char* end) {
    return Asset{type, std::make_shared<const std::string>(begin, end)};
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
