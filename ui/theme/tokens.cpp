#include "ui/theme/tokens.hpp"

#include <array>

namespace stemwise::ui {
namespace {

constexpr Tokens light_tokens{
    .background = hex(0xF3F5F1), .panel = hex(0xFFFFFF), .map = hex(0xFBFCFA), .canvas = hex(0xEEF1EC),
    .line = hex(0xD8DDD5), .grid = hex(0xE9EDE7),
    .text = hex(0x1E2A23), .secondary = hex(0x5E6E65), .faint = hex(0x93A199),
    .accent = hex(0x2A7A4C), .accent_soft = hex(0xE3F0E8), .on_accent = hex(0xFFFFFF),
    .warning = hex(0xB26A00), .error = hex(0xB3261E),
    .hover = Color{30, 42, 35, 14}};

constexpr Tokens dark_tokens{
    .background = hex(0x141816), .panel = hex(0x1C221F), .map = hex(0x171C19), .canvas = hex(0x101311),
    .line = hex(0x2E3732), .grid = hex(0x222925),
    .text = hex(0xE5EBE7), .secondary = hex(0x9DB0A5), .faint = hex(0x6C7D74),
    .accent = hex(0x5BC48A), .accent_soft = hex(0x213A2C), .on_accent = hex(0x0F1A14),
    .warning = hex(0xF0B357), .error = hex(0xF2837B),
    .hover = Color{229, 235, 231, 26}};

constexpr std::array<Color, 6> survey_colors{hex(0x0072B2), hex(0xE69F00), hex(0x009E73), hex(0xCC79A7), hex(0x56B4E9), hex(0xD55E00)};

}  // namespace

const Tokens& tokens_of(ThemeName name) { return name == ThemeName::dark ? dark_tokens : light_tokens; }

Color survey_color(std::size_t order) { return survey_colors[order % survey_colors.size()]; }

Color fate_color(Fate fate) {
  switch (fate) {
    case Fate::survivor: return hex(0x009E73);
    case Fate::ingrowth: return hex(0x56B4E9);
    case Fate::missed_earlier: return hex(0xE69F00);
    case Fate::missing: return hex(0xD55E00);
    case Fate::dead: return hex(0x9A4400);
    case Fate::removed: return hex(0x7A5C48);
    case Fate::outside_coverage: return hex(0x98A39D);
    case Fate::unresolved: return hex(0xCC79A7);
  }
  return hex(0x98A39D);
}

}  // namespace stemwise::ui
