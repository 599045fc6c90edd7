#pragma once
#include <cstddef>

#include "core/survey/fate.hpp"
#include "ui/geometry.hpp"

namespace stemwise::ui {

enum class ThemeName { light, dark };

/// The colours of spec/ui.md by their names there.
struct Tokens {
  Color background, panel, map, canvas;
  Color line, grid;
  Color text, secondary, faint;  ///< faint never carries meaning alone
  Color accent, accent_soft, on_accent;
  Color warning, error;
  Color hover;  ///< laid over whatever can be clicked
};

const Tokens& tokens_of(ThemeName name);
/// Of the n-th inventory in the order of adding; six colours, then again.
Color survey_color(std::size_t order);
Color fate_color(Fate fate);

}  // namespace stemwise::ui
