#pragma once

#include <string>
#include <vector>

namespace fovea::flags {

// The candidate that `word` is most likely a misspelling of: at most a third of its letters (and at
// least one) wrong, missing, too many or swapped with the next. Empty where none is that near.
std::string Suggest(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace fovea::flags
