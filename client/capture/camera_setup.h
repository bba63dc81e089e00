// The steps between opening a device and its first frame, in the order that drivers want.
#pragma once

#include <OpenNI.h>

#include <iosfwd>
#include <opencv2/core/types.hpp>
#include <string>

namespace fovea::capture {

struct CameraOptions {
  std::string device;  // URI, FILE.oni or v4l2:DEPTH,COLOR; empty = the first camera found
  cv::Size size{640, 480};
  cv::Size depth_size;          // of v4l2; empty = that of colour
  double depth_unit_m = 0.001;  // of v4l2
  int fps = 30;
  bool allow_unregistered = false;
  double frame_timeout_s = 5;  // longest time without a frame
  double speed = -1;           // of a recording: 1 = as recorded, -1 = as fast as it is read
};

// "640x480", each 1 to 99999. Throws std::invalid_argument that names the flag.
cv::Size ParseResolution(const std::string& text, const std::string& flag);

struct Streams {
  openni::VideoStream color, depth;
};

// Creates both streams. Throws CameraError for devices without colour or depth.
void CreateStreams(openni::Device& device, Streams& streams);

// The modes that colour and depth have in common: "320x240 at 30, 640x480 at 30" or "none".
std::string CommonModes(const Streams& streams);

// Colour and depth of the size and rate asked. Throws CameraError that lists the modes.
void SetModes(const CameraOptions& options, Streams& streams);

// Depth as seen by the colour camera; frames of one moment; as seen, not as in a mirror. True
// where depth is registered.
bool SetRegistration(openni::Device& device);
void SetSyncAndMirror(openni::Device& device, Streams& streams, std::ostream& notes);

// Throws CameraError unless the streams have the size asked.
void CheckModes(const CameraOptions& options, const Streams& streams);

}  // namespace fovea::capture
