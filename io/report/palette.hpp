#pragma once
#include <array>

namespace stemwise::palette {

// spec/ui.md, light theme: reports are printed on white.
inline constexpr const char* text = "#1E2A23";
inline constexpr const char* secondary = "#5E6E65";
inline constexpr const char* faint = "#93A199";
inline constexpr const char* line = "#D8DDD5";
inline constexpr const char* grid = "#E9EDE7";
inline constexpr const char* accent = "#2A7A4C";
inline constexpr const char* accent_soft = "#E3F0E8";
inline constexpr const char* warning = "#B26A00";
inline constexpr const char* panel = "#F3F5F1";
inline constexpr std::array surveys{"#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00"};
/// In the order of Fate.
inline constexpr std::array fates{"#009E73", "#56B4E9", "#E69F00", "#D55E00", "#6B4A3A", "#8C2D04", "#98A39D", "#CC79A7"};

}  // namespace stemwise::palette
