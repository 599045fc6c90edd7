#include "ui/theme/fonts.hpp"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>
#include <filesystem>
#include <vector>

namespace stemwise::ui {
namespace {

struct Family {
  const char* name;
  const char* regular;
  const char* semibold;
  float size_factor;  ///< ImGui sizes are ascent to descent; a type size is the em square
};

constexpr Family families[] = {
    {"Roboto", "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
     "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf", 1.172f},
    {"DejaVu Sans", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", 1.08f},
};
constexpr const char* icon_face = "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf";

struct Face {
  float size_pt;
  bool semibold;
};
// In the order of TextRole.
constexpr Face faces[text_role_count] = {{17.0f, true}, {14.0f, true}, {13.0f, true}, {13.0f, false}, {12.5f, false}, {11.5f, false}};

// Latin with its extensions, Greek, Cyrillic, punctuation to mathematical signs.
constexpr ImWchar text_ranges[] = {0x20, 0x24F, 0x370, 0x3FF, 0x400, 0x45F, 0x2000, 0x22FF, 0};
constexpr ImWchar icon_ranges[] = {0xF000, 0xF2E0, 0};

void merge_icons(ImFontAtlas& atlas, float size_px) {
  if (!std::filesystem::exists(icon_face)) return;
  ImFontConfig config;
  config.MergeMode = true;
  config.GlyphMinAdvanceX = size_px;
  config.GlyphOffset.y = 0.04f * size_px;
  atlas.AddFontFromFileTTF(icon_face, size_px * 0.88f, &config, icon_ranges);
}

const Family* installed_family() {
  for (const Family& family : families) {
    if (std::filesystem::exists(family.regular)) return &family;
  }
  return nullptr;
}

}  // namespace

void Fonts::load(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  const Family* family = installed_family();
  scale_ = scale;
  family_ = family != nullptr ? family->name : "built in";
  for (std::size_t i = 0; i < text_role_count; ++i) {
    if (family == nullptr) {
      faces_[i] = atlas.AddFontDefault();
      continue;
    }
    const bool bold = faces[i].semibold && std::filesystem::exists(family->semibold);
    const float size_px = std::round(faces[i].size_pt * family->size_factor * scale);  // whole pixels: lines below each other stay sharp
    faces_[i] = atlas.AddFontFromFileTTF(bold ? family->semibold : family->regular, size_px, nullptr, text_ranges);
    merge_icons(atlas, size_px);
  }
  ImGui::GetIO().FontDefault = of(TextRole::body);
  atlas.Build();
}

}  // namespace stemwise::ui
