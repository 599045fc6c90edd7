#include "render/paint/canvas.hpp"

#include <cstring>
#include <numbers>

namespace stemwise::render {
namespace {

constexpr const char* families = "Roboto, DejaVu Sans";

PangoWeight pango_weight(Weight weight) {
  switch (weight) {
    case Weight::regular: return PANGO_WEIGHT_NORMAL;
    case Weight::semibold: return PANGO_WEIGHT_MEDIUM;
    case Weight::bold: return PANGO_WEIGHT_BOLD;
  }
  return PANGO_WEIGHT_NORMAL;
}

}  // namespace

Canvas::Canvas(cairo_t* cairo) : cairo_(cairo), layout_(pango_cairo_create_layout(cairo)) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(pango_layout_get_context(layout_), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(pango_layout_get_context(layout_), FALSE);
  pango_cairo_context_set_resolution(pango_layout_get_context(layout_), 96.0);
}

Canvas::~Canvas() { g_object_unref(layout_); }

void Canvas::set_colour(Rgba c) const { cairo_set_source_rgba(cairo_, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0); }

void Canvas::fill(Rgba colour) const {
  set_colour(colour);
  cairo_fill_preserve(cairo_);
  cairo_new_path(cairo_);
}

void Canvas::stroke(Rgba colour, double width) const {
  set_colour(colour);
  cairo_set_line_width(cairo_, width);
  cairo_stroke(cairo_);
}

void Canvas::rounded(double x, double y, double width, double height, double radius) const {
  constexpr double quarter = std::numbers::pi / 2.0;
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, x + width - radius, y + radius, radius, -quarter, 0.0);
  cairo_arc(cairo_, x + width - radius, y + height - radius, radius, 0.0, quarter);
  cairo_arc(cairo_, x + radius, y + height - radius, radius, quarter, 2.0 * quarter);
  cairo_arc(cairo_, x + radius, y + radius, radius, 2.0 * quarter, 3.0 * quarter);
  cairo_close_path(cairo_);
}

void Canvas::circle(double x, double y, double radius) const {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, x, y, radius, 0.0, 2.0 * std::numbers::pi);
}

void Canvas::line(double x0, double y0, double x1, double y1, Rgba colour, double width) const {
  cairo_move_to(cairo_, x0, y0);
  cairo_line_to(cairo_, x1, y1);
  stroke(colour, width);
}

void Canvas::set_text(const std::string& words, const TextStyle& style) const {
  PangoFontDescription* font = pango_font_description_new();
  pango_font_description_set_family_static(font, families);
  pango_font_description_set_weight(font, pango_weight(style.weight));
  pango_font_description_set_absolute_size(font, style.size_px * PANGO_SCALE);
  pango_layout_set_font_description(layout_, font);
  pango_font_description_free(font);
  pango_layout_set_text(layout_, words.data(), static_cast<int>(words.size()));
}

double Canvas::text_width(const std::string& words, const TextStyle& style) const {
  set_text(words, style);
  PangoRectangle extent;
  pango_layout_get_extents(layout_, nullptr, &extent);
  return static_cast<double>(extent.width) / PANGO_SCALE;
}

void Canvas::text(double x, double y, const std::string& words, const TextStyle& style) const {
  set_text(words, style);
  PangoRectangle extent;
  pango_layout_get_extents(layout_, nullptr, &extent);
  const double width = static_cast<double>(extent.width) / PANGO_SCALE;
  const double baseline = static_cast<double>(pango_layout_get_baseline(layout_)) / PANGO_SCALE;
  const double left = style.align == Align::left ? x : style.align == Align::right ? x - width : x - 0.5 * width;
  const double top = y + 0.36 * style.size_px - baseline;  // capitals centred on y
  if (style.halo.a > 0) {
    cairo_move_to(cairo_, left, top);
    pango_cairo_layout_path(cairo_, layout_);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    stroke(style.halo, 3.0);
  }
  cairo_move_to(cairo_, left, top);
  set_colour(style.colour);
  pango_cairo_show_layout(cairo_, layout_);
  cairo_new_path(cairo_);
}

double Canvas::paragraph(double x, double y, double width, const std::string& words, const TextStyle& style, bool is_drawn) const {
  set_text(words, style);
  pango_layout_set_width(layout_, static_cast<int>(width * PANGO_SCALE));
  pango_layout_set_wrap(layout_, PANGO_WRAP_WORD_CHAR);
  PangoRectangle extent;
  pango_layout_get_extents(layout_, nullptr, &extent);
  if (is_drawn) {
    cairo_move_to(cairo_, x, y);
    set_colour(style.colour);
    pango_cairo_show_layout(cairo_, layout_);
    cairo_new_path(cairo_);
  }
  pango_layout_set_width(layout_, -1);
  return static_cast<double>(extent.height) / PANGO_SCALE;
}

PaintedImage::PaintedImage(PixelSize size, double scale)
    : size_(size), scale_(scale), surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.width, size.height)), cairo_(cairo_create(surface_)) {
  cairo_scale(cairo_, scale, scale);
}

PaintedImage::~PaintedImage() {
  cairo_destroy(cairo_);
  cairo_surface_destroy(surface_);
}

std::uint32_t* PaintedImage::words() {
  cairo_surface_flush(surface_);
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface_));
}

int PaintedImage::stride_words() const { return cairo_image_surface_get_stride(surface_) / 4; }
void PaintedImage::mark_changed() { cairo_surface_mark_dirty(surface_); }

Image PaintedImage::image() const {
  cairo_surface_flush(surface_);
  Image image{size_, std::vector<std::uint8_t>(static_cast<std::size_t>(4) * size_.width * size_.height)};
  const unsigned char* source = cairo_image_surface_get_data(surface_);
  const int stride = cairo_image_surface_get_stride(surface_);
  for (int y = 0; y < size_.height; ++y) {
    const unsigned char* row = source + static_cast<std::ptrdiff_t>(stride) * y;
    std::uint8_t* out = image.rgba.data() + static_cast<std::size_t>(4) * size_.width * y;
    for (int x = 0; x < size_.width; ++x, row += 4, out += 4) {
      std::uint32_t argb;
      std::memcpy(&argb, row, 4);
      const std::uint32_t alpha = argb >> 24;
      if (alpha == 0) continue;
      const auto straight = [alpha](std::uint32_t c) { return static_cast<std::uint8_t>(alpha == 255 ? c : (c * 255 + alpha / 2) / alpha); };
      out[0] = straight((argb >> 16) & 255);
      out[1] = straight((argb >> 8) & 255);
      out[2] = straight(argb & 255);
      out[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return image;
}

}  // namespace stemwise::render
