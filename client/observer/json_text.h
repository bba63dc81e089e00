// What the page is answered, as text.
#pragma once

#include <google/protobuf/message.h>

#include <nlohmann/json.hpp>
#include <string>

namespace fovea::observer {

// In one line. Texts that are no UTF-8 come from outside and must not end anything: what is wrong
// in them is replaced.
std::string JsonText(const nlohmann::json& value);

// With the names of the contract, and with numbers that are 0; "{}" of what cannot be written.
std::string JsonText(const google::protobuf::Message& message);

}  // namespace fovea::observer
