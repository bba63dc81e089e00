// What solid an object is taken for. Camera frame, metres.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fovea {

struct Shape {
  enum class Kind {
    kOther,       // nothing below fits, or too little was seen of it
    kBox,         // the oriented box, filled
    kCylinder,    // standing or lying, by its axis
    kSphere,      //
    kRevolution,  // round about an upright axis, of changing radius: bowls, cups, bottles
    kFlat,        // lies on its support and is low beside its length and width: cards, cutlery
  };
  Kind kind = Kind::kOther;
  float confidence = 0;  // 0 … 1: the probability that it is of this kind
  float residual_m = 0;  // root mean square distance between its surface and the points seen

  // Of cylinders, spheres and what is round about an axis; unset otherwise.
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  // the middle of the axis, or of the sphere
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();    // unit vector, upwards where it stands
  float radius_m = 0;                                // the largest
  float length_m = 0;                                // along the axis; 0 for spheres
  // Of kRevolution: the outer radius at evenly spaced heights, the lowest first; half the spacing
  // from each end.
  std::vector<float> radii_m;
  // Of kOther: what fills its box, where that is known.
  enum class Form {
    kUnknown,
    kOblong,  // upright, its footprint a rectangle whose short sides are half circles
    kBent,    // a rod with round ends that lies and is bent sideways
  };
  Form form = Form::kUnknown;
  float bend_m = 0;  // of kBent: how far its ends lie towards +y of the box from its middle
  // Of kRevolution: open at its top, with an inside, as bowls and cups.
  bool hollow = false;
};

}  // namespace fovea
