#pragma once
#include <array>
#include <string>

struct ImFont;

namespace stemwise::ui {

/// The type scale of spec/ui.md: 17 titles, 14 heads and steps (semi-bold), 13 body, 12.5 tables, 11.5 captions.
enum class TextRole { title, head, strong, body, table, caption };
inline constexpr std::size_t text_role_count = 6;

/// The faces of one window at one scale: Roboto where installed, DejaVu Sans else, icons of Font Awesome merged in.
class Fonts {
 public:
  /// Fills the current ImGui context's atlas. The backend's font texture has to be made anew afterwards.
  void load(float scale);
  ImFont* of(TextRole role) const { return faces_[static_cast<std::size_t>(role)]; }
  float scale() const { return scale_; }
  const std::string& family() const { return family_; }

 private:
  std::array<ImFont*, text_role_count> faces_{};
  float scale_ = 0.0f;
  std::string family_;
};

/// Icons by what they stand for (UTF-8 of Font Awesome 4.7).
namespace icon {
inline constexpr const char* check = "\xEF\x80\x8C";
inline constexpr const char* cross = "\xEF\x80\x8D";
inline constexpr const char* eye = "\xEF\x81\xAE";
inline constexpr const char* eye_off = "\xEF\x81\xB0";
inline constexpr const char* plus = "\xEF\x81\xA7";
inline constexpr const char* caret_down = "\xEF\x83\x97";
inline constexpr const char* caret_right = "\xEF\x83\x9A";
inline constexpr const char* folder = "\xEF\x81\xBB";
inline constexpr const char* file = "\xEF\x80\x96";
inline constexpr const char* tree = "\xEF\x86\xBB";
inline constexpr const char* warning = "\xEF\x81\xB1";
inline constexpr const char* info = "\xEF\x81\x9A";
inline constexpr const char* up = "\xEF\x81\xA2";
inline constexpr const char* home = "\xEF\x80\x95";
inline constexpr const char* star = "\xEF\x80\x85";
inline constexpr const char* trash = "\xEF\x87\xB8";
inline constexpr const char* clock = "\xEF\x80\x97";
}  // namespace icon

}  // namespace stemwise::ui
