#include "server/conversion/color.h"

#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

v1::ColorName NameToProto(ColorName name) {
  switch (name) {
    case ColorName::kBlack:
      return v1::COLOR_NAME_BLACK;
    case ColorName::kGray:
      return v1::COLOR_NAME_GRAY;
    case ColorName::kWhite:
      return v1::COLOR_NAME_WHITE;
    case ColorName::kRed:
      return v1::COLOR_NAME_RED;
    case ColorName::kOrange:
      return v1::COLOR_NAME_ORANGE;
    case ColorName::kYellow:
      return v1::COLOR_NAME_YELLOW;
    case ColorName::kGreen:
      return v1::COLOR_NAME_GREEN;
    case ColorName::kBlue:
      return v1::COLOR_NAME_BLUE;
    case ColorName::kPurple:
      return v1::COLOR_NAME_PURPLE;
    case ColorName::kPink:
      return v1::COLOR_NAME_PINK;
    case ColorName::kBrown:
      return v1::COLOR_NAME_BROWN;
  }
  return v1::COLOR_NAME_UNSPECIFIED;
}

}  // namespace

v1::Color ColorToProto(const std::array<std::uint8_t, 3>& rgb) {
  v1::Color color;
  color.set_red(rgb[0]);
  color.set_green(rgb[1]);
  color.set_blue(rgb[2]);
  return color;
}

v1::ColorPart ToProto(const ColorPart& part) {
  v1::ColorPart proto;
  proto.set_name(NameToProto(part.name));
  proto.set_share(part.share);
  *proto.mutable_mean() = ColorToProto(part.mean);
  *proto.mutable_centroid() = ToProto(part.centroid);
  return proto;
}

}  // namespace fovea::server
