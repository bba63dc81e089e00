#include "client/capture/camera_error.h"

#include <OpenNI.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <regex>

#include "client/capture/recording_file.h"

namespace fovea::capture {
namespace {

namespace fs = std::filesystem;

// OpenNI2 names USB cameras "1d27/0609@1/3": vendor, product, bus, device.
bool IsForbidden(const std::string& uri) {
  std::smatch parts;
  if (!std::regex_search(uri, parts, std::regex("@([0-9]{1,3})/([0-9]{1,3})$"))) return false;
  char node[64];
  std::snprintf(node, sizeof node, "/dev/bus/usb/%03d/%03d", std::stoi(parts[1]),
                std::stoi(parts[2]));
  return access(node, R_OK | W_OK) != 0 && errno == EACCES;
}

bool SpeaksOfPermission(std::string reason) {
  std::transform(reason.begin(), reason.end(), reason.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return reason.find("permission") != std::string::npos ||
         reason.find("denied") != std::string::npos || reason.find("access") != std::string::npos;
}

}  // namespace

std::string OpenNiReason() {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text.empty() ? "OpenNI2 gives no reason" : text;
}

CameraError CannotOpen(const std::string& uri, const std::string& reason) {
  if (IsForbidden(uri) || SpeaksOfPermission(reason)) {
    return CameraError("no permission to open the camera " + uri +
                       ": the udev rule 60-libopenni2-0.rules of the package libopenni2-0 gives "
                       "it; install it, then unplug the camera and plug it in again (" +
                       reason + ")");
  }
  return CameraError("the camera " + uri + " cannot be opened: " + reason);
}

bool IsRecording(const std::string& device) { return device.ends_with(".oni"); }

void CheckRecording(const std::string& path) {
  if (!fs::is_regular_file(path)) throw CameraError("there is no recording " + path);
  if (access(path.c_str(), R_OK) != 0) {
    throw CameraError("cannot read " + path + ": " + std::strerror(errno));
  }
  if (!IsRecording(path) || !IsRecordingFile(path)) {
    throw CameraError(path + " is not a recording of OpenNI2 (.oni)");
  }
  // OpenNI2 itself crashes on a file without any.
  if (!HasRecords(path)) throw CameraError(path + " is damaged: it holds no records");
}

}  // namespace fovea::capture
