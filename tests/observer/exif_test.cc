#include "client/observer/exif.h"

#include <gtest/gtest.h>

#include <string>

namespace fovea::observer {
namespace {

const std::string kStart("\xFF\xD8"), kScan("\xFF\xDA\0\4ab Exif\0\0", 13);

std::string Segment(char kind, const std::string& content) {
  const auto length = static_cast<char>(content.size() + 2);
  return std::string("\xFF") + kind + '\0' + length + content;
}

TEST(WithoutExif, SpoilsTheNamesOfExifSegmentsAlone) {
  const std::string exif("Exif\0\0MM turn left", 18), spoilt("-xif\0\0MM turn left", 18);
  const std::string jfif = Segment('\xE0', "JFIF"), other = Segment('\xE1', "http://ns.adobe.com");
  const std::string comment = Segment('\xFE', exif);
  EXPECT_EQ(
      WithoutExif(kStart + jfif + Segment('\xE1', exif) + other + comment + Segment('\xE1', exif) +
                  kScan),
      kStart + jfif + Segment('\xE1', spoilt) + other + comment + Segment('\xE1', spoilt) + kScan);
}

TEST(WithoutExif, LeavesOtherBytes) {
  const std::string exif("Exif\0\0", 6);
  for (const std::string& bytes :
       {std::string(), kStart, std::string("PNG"), kStart + "\xFF", kStart + "\xFF\xE1",
        kStart + std::string("\xFF\xE1\0\0", 4), kStart + "\xFF\xE1\xFF\xFF" + "Exi",
        Segment('\xE1', exif), kStart + "text" + Segment('\xE1', exif)}) {
    EXPECT_EQ(WithoutExif(bytes), bytes);
  }
}

}  // namespace
}  // namespace fovea::observer
