#include "server/conversion/place.h"

#include "server/conversion/field_error.h"
#include "server/conversion/geometry.h"

namespace fovea::server {

v1::FreePlace ToProto(const FreePlace& place) {
  v1::FreePlace proto;
  *proto.mutable_box() = ToProto(place.box);
  proto.set_clearance_m(place.clearance_m);
  return proto;
}

std::optional<PlaceOptions> PlaceFromProto(const v1::DetectOptions& options) {
  if (!options.has_places()) return std::nullopt;
  constexpr double kMaxSize_m = 5, kMaxMargin_m = 1;
  constexpr std::uint32_t kMaxPlaces = 100;
  const v1::PlaceOptions& proto = options.places();
  PlaceOptions result;
  const Eigen::Vector3d size = FromProto(proto.size());
  RequireField((size.array() > 0).all() && (size.array() <= kMaxSize_m).all(),
               "options.places.size", "must be above 0 and at most 5 m each");
  result.size_m = size.cast<float>();
  if (proto.has_margin_m()) {
    RequireField(proto.margin_m() >= 0 && proto.margin_m() <= kMaxMargin_m,
                 "options.places.margin_m", "must be from 0 to 1 m");
    result.margin_m = static_cast<float>(proto.margin_m());
  }
  RequireField(proto.max_places() <= kMaxPlaces, "options.places.max_places",
               "must be at most 100");
  if (proto.max_places() > 0) result.max_places = static_cast<int>(proto.max_places());
  return result;
}

}  // namespace fovea::server
