#pragma once
#include <string>
#include <variant>
#include <vector>

namespace stemwise {

// A picture as a value: what a chart is before it becomes SVG or PDF. Lengths in px (1/96 inch), y downwards, colours "#RRGGBB".

struct DrawPoint {
  double x = 0.0, y = 0.0;
};

struct DrawRect {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  std::string fill;
  double opacity = 1.0;
};

struct DrawLine {
  DrawPoint from, to;
  std::string stroke;
  double width = 1.0;
  bool dashed = false;
};

struct DrawCircle {
  DrawPoint center;
  double radius = 1.0;
  std::string fill;     ///< "" for hollow
  std::string stroke;
  double opacity = 1.0; ///< of the fill
  bool crossed = false; ///< a cross over it: missing
};

struct DrawPolygon {
  std::vector<DrawPoint> corners;
  std::string fill;  ///< "" for none
  std::string stroke;
  bool dashed = false;
};

enum class TextAnchor { start, middle, end };
struct DrawText {
  DrawPoint at;  ///< baseline
  std::string text;
  double size = 11.0;
  std::string fill;
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, for the title of a vertical axis
};

using DrawItem = std::variant<DrawRect, DrawLine, DrawCircle, DrawPolygon, DrawText>;

struct Drawing {
  double width = 0.0, height = 0.0;
  std::string title;  ///< what it shows, for people who do not see it
  std::vector<DrawItem> items;
};

/// An <svg> element with viewBox, ready to stand inside HTML.
std::string to_svg(const Drawing& drawing);
/// & < > " as entities.
std::string escape_markup(const std::string& text);

}  // namespace stemwise
