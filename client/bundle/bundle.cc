#include "client/bundle/bundle.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/bundle/comparison.h"
#include "client/bundle/readable_files.h"
#include "client/bundle/zip_writer.h"

namespace fovea::bundle {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr const char* kFormat = "fovea-bundle";
constexpr const char* kRequest = "_request.pb";

[[noreturn]] void Refuse(const std::string& text) { throw std::invalid_argument(text); }

std::string TextOf(const json& value) {
  return value.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string JsonOf(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.preserve_proto_field_names = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(message, &text, options).ok()) return "{}\n";
  return text;
}

std::string TimeOf(std::chrono::system_clock::time_point time) {
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(time);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", ms);
}

const char* ModelOf(const v1::LensDistortion& lens) {
  if (lens.model() == v1::DISTORTION_MODEL_KANNALA_BRANDT) return "equidistant";
  return lens.coefficients_size() > 5 ? "rational_polynomial" : "plumb_bob";
}

// As `fovea detect --input FOLDER` reads it; empty where the size of the images is not known.
std::string IntrinsicsOf(const BundledFrame& frame) {
  const v1::Frame& sent = frame.request.frame();
  const std::uint32_t width = frame.answer ? frame.answer->width() : sent.color().width();
  const std::uint32_t height = frame.answer ? frame.answer->height() : sent.color().height();
  const v1::CameraIntrinsics& k = sent.intrinsics();
  if (width == 0 || height == 0 || !sent.has_intrinsics()) return {};
  json file{{"fx", k.fx()}, {"fy", k.fy()},   {"cx", k.cx()},
            {"cy", k.cy()}, {"width", width}, {"height", height}};
  if (k.has_distortion()) {
    const auto& numbers = k.distortion().coefficients();
    file["distortion_model"] = ModelOf(k.distortion());
    file["distortion"] = std::vector<double>(numbers.begin(), numbers.end());
  }
  return TextOf(file);
}

// Unit and camera of depth, as `fovea detect --input FOLDER` reads them.
std::string CapturedOf(const v1::Frame& sent) {
  v1::Frame kept;
  kept.mutable_depth()->set_unit_m(UnitOf(sent.depth()));
  if (sent.has_depth_intrinsics()) {
    *kept.mutable_depth_intrinsics() = sent.depth_intrinsics();
    *kept.mutable_color_from_depth() = sent.color_from_depth();
  }
  return JsonOf(kept);
}

json AboutOf(const std::string& name, const BundledFrame& frame) {
  return {{"name", name},
          {"robot", frame.robot},
          {"frame_id", frame.request.frame().id()},
          {"answered_at", TimeOf(frame.answered_at)},
          {"took_ms", frame.took_ms},
          {"depth_unit_m", UnitOf(frame.request.frame().depth())},
          {"server", frame.server},
          {"server_version", frame.server_version},
          {"outcome", frame.answer ? "answer" : "error"}};
}

void AddFrame(const std::string& name, const BundledFrame& frame, ZipWriter* zip) {
  const v1::Frame& sent = frame.request.frame();
  if (auto color = ColorFile(sent.color())) {
    zip->Add(name + "_color" + color->ending, std::move(color->bytes), /*is_packed=*/true);
  }
  if (auto depth = DepthFile(sent.depth())) {
    zip->Add(name + "_depth" + depth->ending, std::move(depth->bytes), /*is_packed=*/true);
  }
  zip->Add(name + "_options.json", JsonOf(frame.request.options()));
  if (frame.answer) {
    std::string text = JsonOf(*frame.answer);
    if (text.size() <= ZipLimits().max_entry_bytes) {
      zip->Add(name + "_answer.json", std::move(text));
    }
    zip->Add(name + "_answer.pb", BytesOf(*frame.answer));
  } else {
    zip->Add(name + "_error.json", JsonOf(frame.error.value_or(v1::FrameError())));
  }
  zip->Add(name + kRequest, frame.request.SerializeAsString());
}

std::string ReadMe(const BundleNote& note) {
  std::string text =
      "Frames of robots as Fovea got and answered them.\n\n"
      "  fovea detect --input THIS.zip --output FOLDER\n\n"
      "sends them once more and says whether the answers are the same. Unpacked, this is a folder\n"
      "for --input as well: NAME_color, NAME_depth.png, intrinsics.json and fovea_capture.json "
      "(unit\n"
      "and camera of depth of the first frame). NAME_request.pb is what was sent, byte for byte\n"
      "(fovea.v1.DetectRequest), NAME_answer.pb what came back (fovea.v1.Detections), each also "
      "as\n"
      "JSON, where that is not too large. Images that no program could read have no file of their\n"
      "own.\n";
  if (note.num_left_out > 0) {
    text += fmt::format("\n{} more frames of that time found no room.\n", note.num_left_out);
  }
  return text;
}

template <typename Message>
Message Parsed(const ZipReader& zip, const std::string& file) {
  Message message;
  if (!message.ParseFromString(zip.Read(file))) {
    Refuse(file + " in it is no " + Message::descriptor()->full_name());
  }
  return message;
}

}  // namespace

std::string WriteBundle(std::vector<BundledFrame> frames, const BundleNote& note) {
  const auto newest = std::ranges::max_element(frames, {}, &BundledFrame::answered_at);
  ZipWriter zip(newest == frames.end()
                    ? 0
                    : std::chrono::floor<std::chrono::seconds>(newest->answered_at)
                          .time_since_epoch()
                          .count());
  json about{{"format", kFormat},
             {"version", kVersion},
             {"made_by", note.made_by},
             {"left_out", note.num_left_out},
             {"frames", json::array()}};
  std::string intrinsics, captured;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string name = fmt::format("frame_{:04}", i + 1);
    about["frames"].push_back(AboutOf(name, frames[i]));
    AddFrame(name, frames[i], &zip);
    if (intrinsics.empty()) intrinsics = IntrinsicsOf(frames[i]);
    if (captured.empty() && frames[i].answer) captured = CapturedOf(frames[i].request.frame());
    frames[i] = {};  // it is in the file twice now
  }
  if (!intrinsics.empty()) zip.Add("intrinsics.json", intrinsics);
  if (!captured.empty()) zip.Add("fovea_capture.json", captured);
  zip.Add("bundle.json", TextOf(about));
  zip.Add("README.txt", ReadMe(note));
  return zip.Finish();
}

Bundle::Bundle(std::string zip, const ZipLimits& limits) : zip_(std::move(zip), limits) {
  CheckAbout();
  for (const std::string& file : zip_.names()) {
    if (file.size() <= std::string(kRequest).size() || !file.ends_with(kRequest)) continue;
    names_.push_back(file.substr(0, file.size() - std::string(kRequest).size()));
  }
  if (names_.empty()) Refuse("holds no frame");
  std::ranges::sort(names_);
}

void Bundle::CheckAbout() const {
  if (!zip_.Has("bundle.json")) Refuse("has no bundle.json, so it is none of fovea-observer's");
  const json about = json::parse(zip_.Read("bundle.json"), nullptr, /*allow_exceptions=*/false);
  const auto is = [&](const char* key, auto wanted) {
    return about.is_object() && about.contains(key) && about[key] == wanted;
  };
  if (!is("format", kFormat)) Refuse("has a bundle.json that is none of fovea-observer's");
  if (!is("version", kVersion)) Refuse("is of a version that this program does not know");
}

v1::DetectRequest Bundle::RequestOf(const std::string& name) const {
  return Parsed<v1::DetectRequest>(zip_, name + kRequest);
}

std::optional<v1::Detections> Bundle::AnswerOf(const std::string& name) const {
  if (!zip_.Has(name + "_answer.pb")) return std::nullopt;
  return Parsed<v1::Detections>(zip_, name + "_answer.pb");
}

std::optional<v1::FrameError> Bundle::ErrorOf(const std::string& name) const {
  if (!zip_.Has(name + "_error.json")) return std::nullopt;
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = true;  // of later versions
  v1::FrameError error;
  const auto status =
      google::protobuf::util::JsonStringToMessage(zip_.Read(name + "_error.json"), &error, options);
  return status.ok() ? std::optional(error) : std::nullopt;
}

std::string Bundle::ColorFileOf(const std::string& name) const {
  for (const char* ending : {"_color.png", "_color.jpg"}) {
    if (zip_.Has(name + ending)) return zip_.Read(name + ending);
  }
  Refuse("has no " + name + "_color.png (or .jpg)");
}

std::string Bundle::DepthFileOf(const std::string& name) const {
  return zip_.Read(name + "_depth.png");
}

}  // namespace fovea::bundle
