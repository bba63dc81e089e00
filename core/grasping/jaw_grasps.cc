#include "core/grasping/jaw_grasps.h"

#include <algorithm>
#include <cmath>

#include "core/grasping/jaw_contacts.h"
#include "core/grasping/jaw_places.h"
#include "core/grasping/sight.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr std::size_t kMostPlaces = 400;  // of each hand

// Shares of the places of both fingers, by what the camera says of them.
struct HandSights {
  float behind_target = 0, behind_other = 0, outside = 0;  // behind_other: of the worse finger
};

HandSights LookAtFingers(const GraspScene& scene, int label, const HandGrid& grid,
                         const TurnedGrid& turned, const JawPlace& place, float middle_m,
                         float opened_m, const JawGripper& gripper) {
  HandSights sights;
  constexpr int kPlaces = 12;
  for (const float side : {-1.0F, 1.0F}) {
    float behind_other = 0;
    const float along = middle_m + side * (opened_m + gripper.finger_thickness_m) / 2;
    for (const float across : {-0.5F, 0.0F, 0.5F}) {
      for (const float above_m : {0.004F, 0.02F}) {
        const Eigen::Vector3f at = turned.ToGrid(
            along, place.across_m + across * gripper.finger_width_m, place.tip_m + above_m);
        switch (SightOf(scene, label, grid.frame.ToCamera(at))) {
          case Sight::kBehindTarget:
            sights.behind_target += 1.0F / kPlaces;
            break;
          case Sight::kBehindOther:
            behind_other += 2.0F / kPlaces;
            break;
          case Sight::kUnmeasured:
            behind_other += 1.0F / kPlaces;
            break;
          case Sight::kOutsideOfImage:
            sights.outside += 1.0F / kPlaces;
            break;
          default:
            break;
        }
      }
    }
    sights.behind_other = std::max(sights.behind_other, behind_other);
  }
  return sights;
}

float UnseenShare(const GraspScene& scene, int label, const HandGrid& grid,
                  const std::array<JawContact, 2>& contacts) {
  constexpr std::size_t kMost = 8;  // of each contact
  float seen = 0, all = 0;
  for (const JawContact& contact : contacts) {
    const std::size_t step = contact.places.size() / kMost + 1;
    for (std::size_t i = 0; i < contact.places.size(); i += step) {
      all += 1;
      const Sight sight = SightOf(scene, label, grid.frame.ToCamera(contact.places[i]));
      seen += sight == Sight::kOnTarget ? 1 : 0;
    }
  }
  return all > 0 ? 1 - seen / all : 1;
}

// A quarter of a turn, and as many twelfths of half a turn; not by sines, which differ between
// machines.
Eigen::Vector2f ClosingOf(int turn) {
  constexpr float kCos = 0.965925826F, kSin = 0.258819045F;
  Eigen::Vector2f closing = Eigen::Vector2f::UnitY();
  for (int i = 0; i < turn; ++i) {
    closing = {kCos * closing.x() - kSin * closing.y(), kSin * closing.x() + kCos * closing.y()};
  }
  return closing;
}

// How far the object reaches along the closing direction at most.
float ExtentAlong(const TurnedGrid& turned) {
  int first = turned.num_columns, last = -1;
  for (int row = turned.first_row; row <= turned.last_row; ++row) {
    const float* heights = turned.TargetRow(row);
    for (int c = 0; c < turned.num_columns; ++c) {
      if (heights[c] <= HandGrid::kNothing) continue;
      first = std::min(first, c);
      last = std::max(last, c);
    }
  }
  return static_cast<float>(last - first + 1) * turned.cell_m;
}

Grasp::Kind KindOf(const DetectedObject& object, const JawPlace& place, float width_m,
                   float extent_m, bool is_level) {
  constexpr float kThin = 0.55F;  // of the whole
  if (is_level) return Grasp::Kind::kSide;
  if (place.is_part && object.shape.kind == Shape::Kind::kRevolution) return Grasp::Kind::kRim;
  const bool is_thin = width_m < kThin * extent_m;
  return place.is_part || is_thin ? Grasp::Kind::kHandle : Grasp::Kind::kAcross;
}

GraspFamily FamilyOf(Grasp::Kind kind) {
  if (kind == Grasp::Kind::kRim) return GraspFamily::kRim;
  return kind == Grasp::Kind::kHandle ? GraspFamily::kHandle : GraspFamily::kAcross;
}

struct Turn {
  const GraspScene& scene;
  const DetectedObject& object;
  const HandGrid& grid;
  const TurnedGrid& turned;
  float extent_m;
};

void AddGrasp(const Turn& turn, const JawPlace& place, const std::array<JawContact, 2>& contacts,
              const GraspTerms& of_object, JawHand& hand) {
  // Times the friction coefficient: of what columns tell, and of a solid.
  constexpr float kTooSteep = 1.5F, kTooSteepOfSolid = 1.1F;
  constexpr float kFittedFriction = 0.5F;
  const float width = contacts[1].along_m - contacts[0].along_m;
  const float middle = (contacts[1].along_m + contacts[0].along_m) / 2;
  if (contacts[0].places.empty() || contacts[1].places.empty() || width <= 0) return;
  if (width > hand.jaw.max_opening_m) return hand.failures.Add(NoGrasp::Reason::kTooWide);
  const Eigen::Vector2f line = LineBetween(contacts, width);
  const auto steepest = [](float a, float b, float c) {
    return std::max({std::abs(a), std::abs(b), c});
  };
  const float across = steepest(contacts[0].slope_across, contacts[1].slope_across, line.x());
  const float down = steepest(contacts[0].slope_down, contacts[1].slope_down, line.y());
  const float too_steep = contacts[0].is_exact ? kTooSteepOfSolid : kTooSteep;
  if (std::max(across, down) > too_steep * hand.jaw.friction) {
    return hand.failures.Add(NoGrasp::Reason::kSloped);
  }
  ScoredGrasp scored;
  scored.terms = of_object;
  GraspTerms& t = scored.terms;
  t[kTermOpeningLeft] = std::min(2.0F, kCentimetres * (hand.jaw.max_opening_m - width));
  t[kTermClearance] = kCentimetres * place.clearance_m;
  t[kTermTipGap] = kCentimetres * place.tip_gap_m;
  t[kTermPalmGap] = kCentimetres * place.palm_gap_m;
  // The model was fitted with one friction: what is half as rough slips on half the slope.
  const float steeper = kFittedFriction / std::max(0.001F, hand.jaw.friction);
  t[kTermSlopeAcross] = steeper * across;
  t[kTermSlopeDown] = steeper * down;
  t[kTermContactWidth] = std::min(contacts[0].share, contacts[1].share);
  t[kTermContactDepth] =
      kCentimetres * std::min({0.025F, contacts[0].above_tip_m.high, contacts[1].above_tip_m.high});
  t[kTermUnseenContacts] = UnseenShare(turn.scene, turn.object.label, turn.grid, contacts);
  const float opened = OpenedAround(width + 2 * place.room_m, hand.jaw);
  const HandSights sights = LookAtFingers(turn.scene, turn.object.label, turn.grid, turn.turned,
                                          place, middle, opened, hand.jaw);
  t[kTermHandBehindTarget] = sights.behind_target;
  t[kTermHandBehindOther] = sights.behind_other;
  t[kTermHandOutside] = sights.outside;
  t[kTermWidth] = kCentimetres * width;
  t[kTermRoom] = kCentimetres * (opened - width) / 2;
  constexpr float kLevel = 0.5F;  // cosine of the approach with the object's upright
  const bool is_level = std::abs(turn.grid.floor_normal.z()) < kLevel;
  Grasp& grasp = scored.grasp;
  grasp.kind = KindOf(turn.object, place, width, turn.extent_m, is_level);
  grasp.gripper = hand.gripper;
  grasp.tool_center_point =
      turn.grid.frame.ToCamera(turn.turned.ToGrid(middle, place.across_m, place.tip_m));
  grasp.approach = -turn.grid.frame.rotation.col(2);
  grasp.closing = turn.grid.frame.rotation *
                  Eigen::Vector3f(turn.turned.closing.x(), turn.turned.closing.y(), 0);
  grasp.opening_m = width;
  grasp.pre_grasp_opening_m = opened;
  grasp.pre_grasp_distance_m = std::max(kLeastPreGrasp_m, place.depth_m + kPreGraspBeyond_m);
  grasp.unseen_contacts = turn.object.depth_missing ? 1 : t[kTermUnseenContacts];
  scored.family = FamilyOf(grasp.kind);
  hand.grasps.push_back(scored);
}

}  // namespace

void FindJawGrasps(const GraspScene& scene, const DetectedObject& object,
                   const GraspTerms& of_object, const HandGrid& grid, std::vector<JawHand>& hands) {
  const CompletedSolid solid(object, grid.frame);
  const float half_across = solid.HalfExtents().head<2>().norm() + 0.025F;
  std::vector<JawPlace> places;
  // Far apart turns first: the cap on places leaves none of them out.
  for (const int turn : {0, 6, 3, 9, 1, 7, 4, 10, 2, 8, 5, 11}) {
    InterruptionPoint();
    // The object's box is narrowest along its y axis, which is the grid's.
    const TurnedGrid turned = Turned(grid, ClosingOf(turn), half_across);
    const Turn at = {scene, object, grid, turned, ExtentAlong(turned)};
    for (JawHand& hand : hands) {
      JawCloser closer(turned, solid, hand.jaw);
      places.clear();
      FindJawPlaces(grid, turned, hand.jaw, hand.failures, places);
      for (const JawPlace& place : places) {
        if (hand.grasps.size() >= kMostPlaces) break;
        AddGrasp(at, place, closer.CloseOn(place), of_object, hand);
      }
    }
  }
}

}  // namespace fovea
