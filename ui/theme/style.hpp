#pragma once
#include "ui/theme/fonts.hpp"
#include "ui/theme/tokens.hpp"

namespace stemwise::ui {

/// How everything looks just now.
struct Theme {
  ThemeName name = ThemeName::light;
  float scale = 1.0f;          ///< 1 at 100 %
  bool reduce_motion = false;
  const Tokens& tokens() const { return tokens_of(name); }
  bool operator==(const Theme&) const = default;
};

/// Sets the current ImGui context's sizes and colours.
void apply_style(const Theme& theme);

}  // namespace stemwise::ui
