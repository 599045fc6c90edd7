#include <cstdio>

#include "io/report/drawing.hpp"

namespace stemwise {
namespace {

/// Two decimals of a pixel are plenty; no trailing zeros, never "-0".
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string s = text;
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::string attribute(const char* name, const std::string& value) { return std::string(" ") + name + "=\"" + value + "\""; }
std::string attribute(const char* name, double value) { return attribute(name, number(value)); }
std::string paint_attributes(const std::string& fill, const std::string& stroke) {
  return attribute("fill", fill.empty() ? "none" : fill) + (stroke.empty() ? "" : attribute("stroke", stroke));
}

std::string element(const DrawRect& r) {
  return "<rect" + attribute("x", r.x) + attribute("y", r.y) + attribute("width", r.width) + attribute("height", r.height) +
         attribute("fill", r.fill) + (r.opacity < 1.0 ? attribute("fill-opacity", r.opacity) : "") + "/>";
}

std::string element(const DrawLine& l) {
  return "<line" + attribute("x1", l.from.x) + attribute("y1", l.from.y) + attribute("x2", l.to.x) + attribute("y2", l.to.y) +
         attribute("stroke", l.stroke) + attribute("stroke-width", l.width) + (l.dashed ? attribute("stroke-dasharray", "4 3") : "") + "/>";
}

std::string element(const DrawCircle& c) {
  std::string text = "<circle" + attribute("cx", c.center.x) + attribute("cy", c.center.y) + attribute("r", c.radius) +
                     paint_attributes(c.fill, c.stroke) + (c.opacity < 1.0 ? attribute("fill-opacity", c.opacity) : "") + "/>";
  if (!c.crossed) return text;
  const double d = c.radius * 0.71;
  for (const double sign : {1.0, -1.0}) {
    text += element(DrawLine{{c.center.x - d, c.center.y - sign * d}, {c.center.x + d, c.center.y + sign * d}, c.stroke, 1.0, false});
  }
  return text;
}

std::string element(const DrawPolygon& p) {
  std::string points;
  for (const DrawPoint& corner : p.corners) points += (points.empty() ? "" : " ") + number(corner.x) + "," + number(corner.y);
  return "<polygon" + attribute("points", points) + paint_attributes(p.fill, p.stroke) + (p.dashed ? attribute("stroke-dasharray", "5 4") : "") + "/>";
}

std::string element(const DrawText& t) {
  const char* const anchors[] = {"start", "middle", "end"};
  std::string text = "<text" + attribute("x", t.at.x) + attribute("y", t.at.y) + attribute("font-size", t.size) + attribute("fill", t.fill);
  if (t.anchor != TextAnchor::start) text += attribute("text-anchor", anchors[static_cast<int>(t.anchor)]);
  if (t.bold) text += attribute("font-weight", "600");
  if (t.upwards) text += attribute("transform", "rotate(-90 " + number(t.at.x) + " " + number(t.at.y) + ")");
  return text + ">" + escape_markup(t.text) + "</text>";
}

}  // namespace

std::string to_svg(const Drawing& drawing) {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"" + attribute("viewBox", "0 0 " + number(drawing.width) + " " + number(drawing.height)) +
                     attribute("width", drawing.width) + attribute("height", drawing.height) + attribute("aria-label", escape_markup(drawing.title)) + ">\n";
  for (const DrawItem& item : drawing.items) {
    text += std::visit([](const auto& one) { return element(one); }, item) + "\n";
  }
  return text + "</svg>\n";
}

std::string escape_markup(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

}  // namespace stemwise
