#include "io/report/recorded_pages.hpp"

#include <algorithm>
#include <cmath>

#include "io/report/pdf_canvas.hpp"
#include "io/report/recorded_surfaces.hpp"

namespace stemwise {

RecordedPages::RecordedPages(std::unique_ptr<Impl> pages) : impl_(std::move(pages)) {}
RecordedPages::~RecordedPages() = default;
RecordedPages::RecordedPages(RecordedPages&&) noexcept = default;
RecordedPages& RecordedPages::operator=(RecordedPages&&) noexcept = default;

int RecordedPages::count() const { return static_cast<int>(impl_->surfaces.size()); }

PagePicture RecordedPages::picture(int page, int width_px) const {
  const double scale = width_px / PdfCanvas::page_width;
  PagePicture picture{width_px, static_cast<int>(std::lround(PdfCanvas::page_height * scale)), {}};
  const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width_px, picture.height_px));
  {
    const Context cr(cairo_create(image.get()));
    cairo_set_source_rgb(cr.get(), 1.0, 1.0, 1.0);
    cairo_paint(cr.get());
    cairo_scale(cr.get(), scale, scale);
    cairo_set_source_surface(cr.get(), impl_->surfaces.at(static_cast<std::size_t>(page)).get(), 0.0, 0.0);
    cairo_paint(cr.get());
  }
  cairo_surface_flush(image.get());
  const unsigned char* bytes = cairo_image_surface_get_data(image.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
  picture.rgba.reserve(static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px) * 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(picture.height_px); ++row) {
    const auto* words = reinterpret_cast<const std::uint32_t*>(bytes + row * stride);
    for (int x = 0; x < picture.width_px; ++x) {
      for (const int shift : {16, 8, 0}) picture.rgba.push_back(static_cast<std::uint8_t>(words[x] >> shift));
      picture.rgba.push_back(255);
    }
  }
  return picture;
}

}  // namespace stemwise
