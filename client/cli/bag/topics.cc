#include "client/cli/bag/topics.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace fovea::cli {
namespace {

using Topics = std::vector<std::string>;

bool Has(const std::string& topic, const char* word) {
  return topic.find(word) != std::string::npos;
}

bool IsDepth(const std::string& topic) { return Has(topic, "depth"); }
bool IsRegistered(const std::string& topic) {
  return Has(topic, "aligned") || Has(topic, "registered");
}
bool IsInfrared(const std::string& topic) { return Has(topic, "infra") || Has(topic, "/ir/"); }
bool IsCompressed(const std::string& topic) { return Has(topic, "/compressed"); }

Topics Only(const Topics& topics, bool (*holds)(const std::string&), bool wanted) {
  Topics found;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(found),
               [&](const std::string& topic) { return holds(topic) == wanted; });
  return found;
}

bool IsInfoOfDepth(const std::string& info) {
  return info.find("depth", info.rfind('/') + 1) != std::string::npos;
}

// Those in the namespace of the colour topic, the innermost that has any.
Topics Innermost(const Topics& infos, const std::string& color_topic) {
  Topics found;
  std::size_t longest = 0;
  for (const std::string& info : infos) {
    const std::size_t slash = info.rfind('/');
    if (slash == std::string::npos || slash < longest) continue;
    if (!color_topic.starts_with(info.substr(0, slash + 1))) continue;
    if (slash > longest) found.clear();
    found.push_back(info);
    longest = slash;
  }
  return found;
}

// Those, where there are some.
Topics Rather(const Topics& topics, bool (*holds)(const std::string&), bool wanted) {
  Topics found = Only(topics, holds, wanted);
  return found.empty() ? topics : found;
}

std::string List(const Topics& topics) {
  std::string text;
  for (const std::string& topic : topics) text += (text.empty() ? "" : ", ") + topic;
  return text.empty() ? "none" : text;
}

std::string Choose(const Topics& candidates, const Topics& all, const std::string& wanted,
                   const std::string& flag) {
  if (!wanted.empty()) {
    if (std::find(all.begin(), all.end(), wanted) != all.end()) return wanted;
    throw std::invalid_argument(flag + ": it has no images of " + wanted +
                                "; topics with images: " + List(all));
  }
  if (candidates.size() == 1) return candidates.front();
  throw std::invalid_argument("give " + flag + "; topics with images: " + List(all));
}

}  // namespace

std::string ColorTopic(const Topics& topics, const std::string& wanted) {
  const Topics color = Only(Only(topics, IsDepth, false), IsInfrared, false);
  return Choose(Rather(color, IsCompressed, false), topics, wanted, "--color-topic");
}

std::string DepthTopic(const Topics& topics, const std::string& wanted) {
  const Topics depth = Rather(Only(topics, IsDepth, true), IsRegistered, true);
  return Choose(Rather(depth, IsCompressed, false), topics, wanted, "--depth-topic");
}

bool IsRectified(const std::string& color_topic) { return Has(color_topic, "/image_rect"); }

std::string InfoTopic(const Topics& infos, const std::string& color_topic) {
  const Topics beside = Innermost(infos, color_topic);
  for (const std::string& info : beside) {
    if (info.ends_with("/camera_info")) return info;  // the name that ROS gives it
  }
  const Topics color = Only(beside, IsInfoOfDepth, false);
  return color.size() == 1 ? color.front() : std::string();
}

}  // namespace fovea::cli
