// What is fuzzed: each target takes the bytes of anybody and ends the program where it does what it
// should not. All are in one program, since most of what one costs to build they share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fovea::fuzzing {

using Target = void (*)(const std::uint8_t* data, std::size_t size);

void FuzzBundle(const std::uint8_t* data, std::size_t size);
void FuzzJpeg(const std::uint8_t* data, std::size_t size);
void FuzzMcap(const std::uint8_t* data, std::size_t size);
void FuzzPng(const std::uint8_t* data, std::size_t size);
void FuzzRequest(const std::uint8_t* data, std::size_t size);
void FuzzRoutes(const std::uint8_t* data, std::size_t size);
void FuzzRvl(const std::uint8_t* data, std::size_t size);
void FuzzZstd(const std::uint8_t* data, std::size_t size);

// "bundle", "jpeg", … as the folders of the corpus are called; null for another name.
Target TargetOf(std::string_view name);

}  // namespace fovea::fuzzing
