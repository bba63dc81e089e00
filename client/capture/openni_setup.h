// The steps between opening a device of OpenNI2 and its first frame, in the order that drivers
// want.
#pragma once

#include <OpenNI.h>

#include <iosfwd>
#include <string>

#include "client/capture/camera_options.h"

namespace fovea::capture {

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
