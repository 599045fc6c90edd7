#pragma once
#include <string>

#include "core/survey/alignment.hpp"

namespace stemwise::ui {

/// "17 % as good", "no other pose fits".
std::string second_best_words(const Acceptance& acceptance);
/// "x y yaw z roll pitch".
std::string observed_words(const ObservedDofs& observed);

}  // namespace stemwise::ui
