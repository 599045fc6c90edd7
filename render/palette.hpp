#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/survey/fate.hpp"

namespace stemwise::render {

/// sRGB, straight alpha, 0..255.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba&) const = default;
  constexpr Rgba with_alpha(double alpha) const { return {r, g, b, static_cast<std::uint8_t>(alpha * 255.0 + 0.5)}; }
};

/// 0xRRGGBB, opaque.
constexpr Rgba rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex), 255};
}
/// From a (t = 0) to b (t = 1), t clamped.
Rgba mix(Rgba a, Rgba b, double t);

enum class Theme { light, dark };

/// The colour tokens of ui.md.
struct ThemeColours {
  Rgba background, panel, map, canvas;
  Rgba line, grid;
  Rgba text, secondary, faint;
  Rgba accent, accent_soft;
  Rgba warning;
  Rgba shadow_side;  ///< what shaded surfaces (ground, the dark side of a stem) fade to
};
const ThemeColours& theme_colours(Theme theme);

/// Surveys in order (by date, then as given); repeats after six.
Rgba survey_colour(std::size_t order);

/// How a tree is marked on the map: fates are told by colour and shape.
enum class MarkShape : std::uint8_t { disc, plus, ring, cross, hollow, diamond, solid_cross, square };
Rgba fate_colour(Fate fate);
MarkShape fate_shape(Fate fate);

/// Sequential, colour-blind safe, dark blue (0) to yellow (1).
Rgba cividis(double t);
/// Diverging, symmetric about zero: -1 purple, 0 near white (light) or near black (dark), +1 orange.
Rgba purple_white_orange(double t, Theme theme);
/// "Within error", "unknown".
Rgba neutral_grey(Theme theme);

}  // namespace stemwise::render
