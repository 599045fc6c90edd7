#pragma once
#include <string>

#include "ui/frame.hpp"

namespace stemwise::ui {

// What a decision on the selected tree would do, said on the button before it is done. Empty where it can do nothing.

std::string accept_words(const Frame& frame);
std::string reject_words(const Frame& frame);
std::string unlink_words(const Frame& frame);
std::string split_words(const Frame& frame);

}  // namespace stemwise::ui
