#pragma once
#include <string>

#include "core/survey/tables.hpp"

namespace stemwise::ui {

/// Why a match is as sure as it is: how far apart, whether the diameters agree, what else it could be.
std::string confidence_words(const MatchRow& match);

}  // namespace stemwise::ui
