#pragma once
#include <string>
#include <vector>

#include "ui/actions/action.hpp"
#include "ui/geometry.hpp"
#include "ui/requests.hpp"
#include "ui/theme/fonts.hpp"
#include "ui/theme/style.hpp"
#include "ui/widgets/focus_order.hpp"
#include "ui/widgets/registry.hpp"

namespace stemwise::ui {

enum class Tone { text, secondary, faint, accent, on_accent, warning, error };
enum class Align { left, center, right };

struct ButtonLook {
  bool primary = false;      ///< the one thing to do here
  bool quiet = false;        ///< text only: no fill, no line
  bool active = false;       ///< switched on
  bool plate = false;        ///< over the map: a plate of the panels' colour
  float width = 0.0f;        ///< px; 0: as wide as the label; negative: up to the right edge
  std::string key;           ///< stands at the right of the label
  const char* icon = nullptr;
  std::string why_not;       ///< not empty: greyed out, with this reason on hover
  std::string tooltip;
};

struct InputLook {
  std::string hint;
  float width = 0.0f;        ///< px; 0: up to the right edge
  int lines = 1;
  std::string why_not;
};

/// All controls of the window: thin around Dear ImGui, in our look, each recorded in the registry under its path.
/// Draw at the ImGui cursor and move it on, unless a function takes a Rect.
class Widgets {
 public:
  Theme theme;
  Fonts fonts;
  WidgetRegistry registry;
  FocusOrder focus;

  float px(float at_100_percent) const { return at_100_percent * theme.scale; }
  const Tokens& tokens() const { return theme.tokens(); }
  Color color(Tone tone) const;

  // Text
  void text(const std::string& text, TextRole role = TextRole::body, Tone tone = Tone::text);
  void paragraph(const std::string& text, TextRole role = TextRole::body, Tone tone = Tone::text);  ///< wraps at the right edge
  /// The height that `text` needs in a column of this width, and the text itself there.
  float line_step(TextRole role) const;  ///< from line to line of running text
  float wrapped_height(const std::string& text, TextRole role, float width_px) const;
  void wrapped_in(const Rect& rect, const std::string& text, TextRole role, Tone tone);
  void section(const std::string& title);  ///< a head with air above
  /// Name left, value right-aligned, in one line of 24 px.
  void fact(const std::string& path, const std::string& name, const std::string& value, const std::string& tooltip = {});
  float text_width(const std::string& text, TextRole role) const;
  float line_height(TextRole role) const;
  /// The text with its middle left out where it is wider: names that differ at their end stay different.
  std::string middle_shortened(const std::string& text, TextRole role, float width_px) const;
  /// Fits the text into the rectangle; what does not fit ends with an ellipsis and is told in full on hover.
  void text_in(const Rect& rect, const std::string& text, TextRole role, Tone tone, Align align = Align::left);
  void text_in(const Rect& rect, const std::string& text, TextRole role, Color color, Align align = Align::left);

  // Controls
  bool button(const std::string& path, const std::string& label, const ButtonLook& look = {});
  bool button_in(const Rect& rect, const std::string& path, const std::string& label, const ButtonLook& look = {});
  /// A button of an action: label, key, availability and tooltip come from the registry of actions.
  void action_button(const std::string& path, ActionId id, const Availabilities& available, Requests& requests, ButtonLook look = {});
  void action_button_in(const Rect& rect, const std::string& path, ActionId id, const Availabilities& available, Requests& requests,
                        ButtonLook look = {});
  bool checkbox(const std::string& path, const std::string& label, bool& value, const std::string& tooltip = {});
  bool combo(const std::string& path, const std::vector<std::string>& items, int& current, float width_px = 0.0f);
  bool input(const std::string& path, std::string& value, const InputLook& look = {});
  /// A field for a file's path with a button beside it; true: the button was pressed.
  bool path_field(const std::string& path, std::string& value, const std::string& browse_path, const InputLook& look = {});
  /// A decimal comma counts as a point. While the text is no number the value stays, and the field says so.
  /// With `at_zero` an empty field is 0 and says what that means: "from the coverage".
  bool number(const std::string& path, double& value, const char* format, float width_px = 0.0f, const char* at_zero = nullptr);
  /// `format`: printf's, of a float ("%.0f %%").
  bool slider(const std::string& path, float& value, float low, float high, const char* format, float width_px = 0.0f);
  bool fold(const std::string& path, const std::string& label, bool& open);  ///< a head that opens and closes
  /// Invisible, clickable: for rows and cards that draw themselves. Records, draws hover and focus.
  bool area(const std::string& path, const Rect& rect, const std::string& value, bool rounded = true);
  void pill(const std::string& path, const std::string& label, Color fill, float right_x, float y);
  void progress_bar(const Rect& rect, double fraction);
  /// A bar to drag between two panels; changes `size` by the mouse. Returns while it is dragged.
  bool splitter(const std::string& path, const Rect& rect, bool vertical, float& size, float min, float max, bool grows_back);

  // Drawing
  void fill(const Rect& rect, Color color, float rounding = 0.0f);
  void outline(const Rect& rect, Color color, float rounding = 0.0f);
  void hairline(float x0, float y0, float x1, float y1);
  void gap(float height_at_100_percent);
  void tooltip(const std::string& text);
  void tooltip_at(float x, float y, const std::string& text);  ///< with its upper left corner there
  void push_font(TextRole role);
  void pop_font();
  float available_width() const;
  Rect next_rect(float width_px, float height_px) const;  ///< at the cursor
  /// Records the last ImGui item under the path.
  void record_last(const std::string& path, const std::string& value, bool enabled = true, bool is_text = false, bool by_tab = true);
  void record(const std::string& path, const Rect& rect, const std::string& value, bool enabled = true);

 private:
  void draw_button(const Rect& rect, const std::string& label, const ButtonLook& look, bool hovered, bool held);
  void focus_ring(const Rect& rect);
  void place_list(const Rect& field, const std::vector<std::string>& items) const;

  void draw_refused(const std::string& path);

  /// The number field whose text is none, and that text.
  struct Refused {
    std::string path, text;
  };
  Refused refused_;
  double value_before_typing_ = 0.0;  ///< of the number field that has the keyboard
};

}  // namespace stemwise::ui
