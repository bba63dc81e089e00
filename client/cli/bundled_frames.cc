#include "client/cli/bundled_frames.h"

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "client/bundle/bundle.h"
#include "client/bundle/shown.h"
#include "client/cli/endings.h"
#include "client/cli/files.h"
#include "client/rpc_error.h"

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

// Of a frame that was refused before it had come as a whole, as one too many of a robot is. What
// was refused for what it is, without images too, can be sent, and is refused again.
std::optional<std::string> WhyNotSent(const bundle::Bundle& bundle, const std::string& name,
                                      const SentBefore& before) {
  const v1::Frame& frame = before.request.frame();
  if (before.answer || !frame.color().data().empty() || !frame.depth().data().empty()) {
    return std::nullopt;
  }
  const std::optional<v1::FrameError> error = bundle.ErrorOf(name);
  if (!error || error->code() == grpc::StatusCode::INVALID_ARGUMENT) return std::nullopt;
  const client::RpcError shown(
      {static_cast<grpc::StatusCode>(error->code()), bundle::Shown(error->message())});
  return name + " was refused before its images came: " + shown.what() +
         "; there is nothing to send";
}

}  // namespace

bool IsBundle(const std::string& path) { return LowerEnding(path) == ".zip"; }

FrameList ListBundle(const std::string& path) {
  const std::string bytes = ReadFile(path);
  FrameList list;
  try {
    const auto bundle = std::make_shared<const bundle::Bundle>(bytes);
    for (const std::string& name : bundle->names()) {
      FrameFiles files = FilesOf(path, bundle, name);
      if (auto why = WhyNotSent(*bundle, name, *files.sent_before)) {
        list.notes.push_back(*std::move(why));
        continue;
      }
      list.frames.push_back(std::move(files));
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
