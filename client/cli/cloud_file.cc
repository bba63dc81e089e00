#include <bit>

#include "client/cli/cloud.h"

namespace fovea::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

void AppendPosition(const CloudPoint& point, std::string* file) {
  file->append(reinterpret_cast<const char*>(point.position.val), sizeof point.position.val);
}

}  // namespace

std::string MakePly(const std::vector<CloudPoint>& cloud) {
  std::string file =
      "ply\nformat binary_little_endian 1.0\n"
      "comment metres; camera frame: x right, y down, z forward\n"
      "element vertex " +
      std::to_string(cloud.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  for (const CloudPoint& point : cloud) {
    AppendPosition(point, &file);
    for (const int channel : {2, 1, 0}) file.push_back(static_cast<char>(point.bgr[channel]));
  }
  return file;
}

std::string MakePcd(const std::vector<CloudPoint>& cloud) {
  const std::string count = std::to_string(cloud.size());
  std::string file =
      "# .PCD v0.7 - Point Cloud Data file format\n"
      "# metres; camera frame: x right, y down, z forward\n"
      "VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " +
      count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
  for (const CloudPoint& point : cloud) {
    AppendPosition(point, &file);
    for (const int channel : {0, 1, 2}) file.push_back(static_cast<char>(point.bgr[channel]));
    file.push_back(0);
  }
  return file;
}

}  // namespace fovea::cli
