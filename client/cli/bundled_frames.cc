#include "client/cli/bundled_frames.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "client/bundle/bundle.h"
#include "client/cli/endings.h"
#include "client/cli/files.h"

namespace fovea::cli {
namespace {

FrameFiles FilesOf(const std::string& path, const std::shared_ptr<const bundle::Bundle>& bundle,
                   const std::string& name) {
  FrameFiles files{.id = name,
                   .color_path = path + ", " + name + "_color",
                   .depth_path = path + ", " + name + "_depth.png"};
  files.read_color = [bundle, name] { return bundle->ColorFileOf(name); };
  files.read_depth = [bundle, name] { return bundle->DepthFileOf(name); };
  files.sent_before = std::make_shared<const SentBefore>(
      SentBefore{.request = bundle->RequestOf(name), .answer = bundle->AnswerOf(name)});
  return files;
}

}  // namespace

bool IsBundle(const std::string& path) { return LowerEnding(path) == ".zip"; }

FrameList ListBundle(const std::string& path) {
  const std::string bytes = ReadFile(path);
  FrameList list;
  try {
    const auto bundle = std::make_shared<const bundle::Bundle>(bytes);
    for (const std::string& name : bundle->names()) {
      list.frames.push_back(FilesOf(path, bundle, name));
      if (list.frames.back().sent_before->request.options().tracking().enabled()) {
        list.notes.push_back(name + ": was tracked; sent alone, its objects have no tracks");
      }
    }
  } catch (const std::invalid_argument& bad) {
    throw std::runtime_error(path + " " + bad.what());
  }
  return list;
}

}  // namespace fovea::cli
