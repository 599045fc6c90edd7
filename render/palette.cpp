#include "render/palette.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr ThemeColours light_colours{rgb(0xF3F5F1), rgb(0xFFFFFF), rgb(0xFBFCFA), rgb(0xEEF1EC), rgb(0xD8DDD5), rgb(0xE9EDE7), rgb(0x1E2A23),
                                     rgb(0x5E6E65), rgb(0x93A199), rgb(0x2A7A4C), rgb(0xE3F0E8), rgb(0xB26A00), rgb(0x3B463F)};
constexpr ThemeColours dark_colours{rgb(0x141816), rgb(0x1C221F), rgb(0x171C19), rgb(0x101311), rgb(0x2E3732), rgb(0x222925), rgb(0xE5EBE7),
                                    rgb(0x9DB0A5), rgb(0x6C7D74), rgb(0x5BC48A), rgb(0x213A2C), rgb(0xF0B357), rgb(0x0A0D0B)};

/// Piecewise linear through evenly spaced stops.
template <std::size_t N>
Rgba along(const std::array<Rgba, N>& stops, double t) {
  const double at = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * static_cast<double>(N - 1);
  const auto i = std::min(static_cast<std::size_t>(at), N - 2);
  return mix(stops[i], stops[i + 1], at - static_cast<double>(i));
}

}  // namespace

Rgba mix(Rgba a, Rgba b, double t) {
  t = std::clamp(t, 0.0, 1.0);
  const auto channel = [t](std::uint8_t x, std::uint8_t y) { return static_cast<std::uint8_t>(std::lround(x + (y - x) * t)); };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

const ThemeColours& theme_colours(Theme theme) { return theme == Theme::dark ? dark_colours : light_colours; }

Rgba survey_colour(std::size_t order) {
  constexpr std::array colours{rgb(0x0072B2), rgb(0xE69F00), rgb(0x009E73), rgb(0xCC79A7), rgb(0x56B4E9), rgb(0xD55E00)};
  return colours[order % colours.size()];
}

Rgba fate_colour(Fate fate) {
  switch (fate) {
    case Fate::survivor: return rgb(0x009E73);
    case Fate::ingrowth: return rgb(0x56B4E9);
    case Fate::missed_earlier: return rgb(0xE69F00);
    case Fate::missing: return rgb(0xD55E00);
    case Fate::dead: return rgb(0x9A4400);
    case Fate::removed: return rgb(0x7A5C48);
    case Fate::outside_coverage: return rgb(0x98A39D);
    case Fate::unresolved: return rgb(0xCC79A7);
  }
  return rgb(0x98A39D);
}

MarkShape fate_shape(Fate fate) {
  switch (fate) {
    case Fate::survivor: return MarkShape::disc;
    case Fate::ingrowth: return MarkShape::plus;
    case Fate::missed_earlier: return MarkShape::ring;
    case Fate::missing: return MarkShape::cross;
    case Fate::dead: return MarkShape::solid_cross;
    case Fate::removed: return MarkShape::square;
    case Fate::outside_coverage: return MarkShape::hollow;
    case Fate::unresolved: return MarkShape::diamond;
  }
  return MarkShape::disc;
}

Rgba cividis(double t) {
  // Nuñez, Anderton and Renslow 2018, sampled at nine even steps.
  constexpr std::array stops{rgb(0x00224E), rgb(0x1A386F), rgb(0x434E6C), rgb(0x61656F), rgb(0x7D7C78),
                             rgb(0x9B9476), rgb(0xBCAF6F), rgb(0xDFCB5D), rgb(0xFEE838)};
  return along(stops, t);
}

Rgba purple_white_orange(double t, Theme theme) {
  constexpr std::array on_light{rgb(0x542788), rgb(0x998EC3), rgb(0xEFEFEF), rgb(0xF1A340), rgb(0xB35806)};
  constexpr std::array on_dark{rgb(0xA98BDB), rgb(0x7B6BAE), rgb(0xE4E4E4), rgb(0xF1A340), rgb(0xE66F0B)};
  return along(theme == Theme::dark ? on_dark : on_light, 0.5 + 0.5 * t);
}

Rgba neutral_grey(Theme theme) { return theme == Theme::dark ? rgb(0x6F7A74) : rgb(0xA9B1AC); }

}  // namespace stemwise::render
