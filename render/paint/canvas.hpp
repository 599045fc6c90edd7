#pragma once
#include <cairo.h>
#include <pango/pangocairo.h>

#include <string>

#include "render/palette.hpp"
#include "render/picture.hpp"

namespace stemwise::render {

enum class Align { left, centre, right };
enum class Weight { regular, semibold, bold };

struct TextStyle {
  double size_px = 13.0;
  Weight weight = Weight::regular;
  Rgba colour;
  Align align = Align::left;
  Rgba halo{0, 0, 0, 0};  ///< drawn around the letters where its alpha is not 0
};

/// Cairo and pango in the house's look: lengths in interface pixels at 100 %, the typefaces of ui.md. Draws on any cairo
/// surface (picture, SVG, PDF), does not own it.
class Canvas {
 public:
  explicit Canvas(cairo_t* cairo);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  cairo_t* cairo() const { return cairo_; }
  void set_colour(Rgba colour) const;
  void fill(Rgba colour) const;
  void stroke(Rgba colour, double width) const;
  void rounded(double x, double y, double width, double height, double radius) const;
  void circle(double x, double y, double radius) const;
  void line(double x0, double y0, double x1, double y1, Rgba colour, double width) const;
  /// `y` is the middle of the line of text (of its x-height to be seen as centred), `x` the left, middle or right by the style.
  void text(double x, double y, const std::string& words, const TextStyle& style) const;
  double text_width(const std::string& words, const TextStyle& style) const;
  /// Left-aligned words wrapped to a width, `y` the top; returns the height, and only that when `is_drawn` is false.
  double paragraph(double x, double y, double width, const std::string& words, const TextStyle& style, bool is_drawn) const;

 private:
  void set_text(const std::string& words, const TextStyle& style) const;

  cairo_t* cairo_;
  PangoLayout* layout_;
};

/// A picture to paint on: `size` pixels, one interface pixel is `scale` of them.
class PaintedImage {
 public:
  PaintedImage(PixelSize size, double scale);
  ~PaintedImage();
  PaintedImage(const PaintedImage&) = delete;
  PaintedImage& operator=(const PaintedImage&) = delete;

  cairo_t* cairo() const { return cairo_; }
  PixelSize size() const { return size_; }
  double scale() const { return scale_; }
  /// cairo's words, 0xAARRGGBB with colours times alpha, `stride_words()` per row from the top. Flushes what was painted;
  /// call mark_changed() after writing.
  std::uint32_t* words();
  int stride_words() const;
  void mark_changed();
  Image image() const;  ///< straight alpha

 private:
  PixelSize size_;
  double scale_;
  cairo_surface_t* surface_;
  cairo_t* cairo_;
};

}  // namespace stemwise::render
