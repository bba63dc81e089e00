#include "client/cli/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "client/cli/endings.h"
#include "client/image_files/image_files.h"

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

// Nobody may take it for all of it. Devices and pipes stay.
void RemoveHalf(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) std::filesystem::remove(path, error);
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

std::vector<std::filesystem::path> FilesIn(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  if (error) throw std::runtime_error("cannot read " + folder.string() + ": " + error.message());
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::directory_entry& entry : entries) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string ReadTextOfFolder(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw std::runtime_error(path + " is no regular file");
  }
  return ReadFile(path, kLargestText);
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
  if (!file) FailOn("cannot write", path);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return;
  const int why = errno;
  RemoveHalf(path);
  errno = why;
  FailOn("cannot write", path);
}

cv::Mat DecodeColor(const std::string& file, const std::string& path) {
  try {
    return image_files::DecodeColor(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + " is not a readable colour image: " + error.what());
  }
}

cv::Mat DecodeDepth(const std::string& file, const std::string& path) {
  try {
    return image_files::DecodeDepth(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + " is not a 16-bit depth image: " + error.what());
  }
}

void WriteImage(const std::string& path, const cv::Mat& image) {
  constexpr int kJpegQuality = 92;
  if (IsPngName(path)) return WriteFile(path, image_files::EncodePng(image));
  if (IsJpegName(path)) return WriteFile(path, image_files::EncodeJpeg(image, kJpegQuality));
  throw std::runtime_error("cannot write " + path + ": end it in .png or .jpg");
}

}  // namespace fovea::cli
