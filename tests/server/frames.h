// Small valid requests, in every encoding, for tests to send and to break.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::testing {

constexpr int kWidth = 32, kHeight = 24;
constexpr std::size_t kDepthBytes = 2UL * kWidth * kHeight;  // of 16UC1

cv::Mat TestColor();   // CV_8UC3, R first, smooth
cv::Mat TestDepth();   // CV_16UC1 in millimetres, with some zeros
cv::Mat TestMeters();  // CV_32FC1, what TestDepth() means; NaN where nothing was measured

std::string BytesOf(const cv::Mat& image);
std::string PngOf(const cv::Mat& image);       // three channels: R first
std::string JpegOf(const cv::Mat& image_rgb);  // quality 95
std::string ZstdOf(const std::string& bytes);
std::string RvlOf(const cv::Mat& depth);

// TestColor() and TestDepth() in every encoding of the contract.
std::vector<v1::ColorImage> TestColors();
std::vector<v1::DepthImage> TestDepths();

// RGB8 and 16UC1 with everything that a frame needs.
v1::Frame TestFrame();
v1::DetectRequest TestRequest();

v1::ColorImage ColorMessage(v1::ColorEncoding encoding, std::string bytes, int width = 0,
                            int height = 0);
v1::DepthImage DepthMessage(v1::DepthEncoding encoding, std::string bytes, int width = 0,
                            int height = 0);

// Files whose headers claim width x height, with a correct checksum and no pixels to speak of.
std::string PngClaiming(std::uint32_t width, std::uint32_t height);
std::string JpegClaiming(std::uint16_t width, std::uint16_t height);

}  // namespace fovea::testing
