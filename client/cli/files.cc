#include "client/cli/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace fovea::cli {
namespace {

[[noreturn]] void FailOn(const std::string& what, const std::string& path) {
  const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
  throw std::runtime_error(what + " " + path + reason);
}

void RequireSize(const std::string& path, std::uintmax_t size, std::uintmax_t most) {
  if (size <= most) return;
  const std::uintmax_t mib = most >> 20;
  throw std::runtime_error(
      path + " has more than " +
      (mib < 1024 ? std::to_string(mib) + " MiB" : std::to_string(mib / 1024) + " GiB"));
}

constexpr int kJpegQuality = 92;

cv::Mat Decode(const std::string& file, int flags) {
  try {
    return cv::imdecode(
        cv::Mat(1, static_cast<int>(file.size()), CV_8UC1, const_cast<char*>(file.data())), flags);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

std::string ReadFile(const std::string& path, std::uintmax_t most) {
  // Opening a folder works; reading from it fails deep inside of the library.
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error("cannot read " + path + ": it is a folder");
  }
  const bool has_size = std::filesystem::is_regular_file(path);
  RequireSize(path, has_size ? std::filesystem::file_size(path) : 0, most);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) FailOn("cannot read", path);
  std::string bytes, part(std::size_t{1} << 20, '\0');
  while (file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    bytes.append(part.data(), static_cast<std::size_t>(file.gcount()));
    RequireSize(path, bytes.size(), most);  // pipes and devices do not say theirs
  }
  if (file.bad()) FailOn("cannot read", path);
  if (bytes.empty()) throw std::runtime_error(path + " is empty");
  return bytes;
}

std::string ReadFlagFile(const std::string& flag, const std::string& path) {
  try {
    return ReadFile(path, kLargestText);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(flag + ": " + error.what());
  }
}

void WriteFile(const std::string& path, const std::string& bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) FailOn("cannot write", path);
}

cv::Mat DecodeColor(const std::string& file, const std::string& path) {
  cv::Mat image = Decode(file, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  if (image.empty()) throw std::runtime_error(path + " is not a readable colour image");
  return image;
}

cv::Mat DecodeDepth(const std::string& file, const std::string& path) {
  cv::Mat image = Decode(file, cv::IMREAD_UNCHANGED);
  if (image.type() != CV_16UC1) throw std::runtime_error(path + " is not a 16-bit depth image");
  return image;
}

void WriteImage(const std::string& path, const cv::Mat& image) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos) {
    throw std::runtime_error("cannot write " + path + ": give it an extension, for example .png");
  }
  std::vector<unsigned char> bytes;
  try {
    cv::imencode(path.substr(dot), image, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  } catch (const cv::Exception&) {
    throw std::runtime_error("cannot write " + path + ": unknown image format " + path.substr(dot));
  }
  WriteFile(path, {bytes.begin(), bytes.end()});
}

}  // namespace fovea::cli
