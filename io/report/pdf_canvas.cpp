#include "io/report/pdf_canvas.hpp"

#include <cairo-pdf.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <sstream>

#include "io/report/recorded_surfaces.hpp"

namespace stemwise {
namespace {

struct ObjectDeleter {
  void operator()(gpointer o) const { g_object_unref(o); }
};
struct FontDeleter {
  void operator()(PangoFontDescription* f) const { pango_font_description_free(f); }
};
struct FontOptionsDeleter {
  void operator()(cairo_font_options_t* o) const { cairo_font_options_destroy(o); }
};
struct AttributesDeleter {
  void operator()(PangoAttrList* a) const { pango_attr_list_unref(a); }
};
using Layout = std::unique_ptr<PangoLayout, ObjectDeleter>;

void set_color(cairo_t* cr, const std::string& color, double opacity = 1.0) {
  unsigned r = 0, g = 0, b = 0;
  if (color.size() == 7) std::sscanf(color.c_str(), "#%2x%2x%2x", &r, &g, &b);
  cairo_set_source_rgba(cr, r / 255.0, g / 255.0, b / 255.0, opacity);
}

Layout layout_of(cairo_t* cr, const std::string& text, double size_pt, bool bold) {
  Layout layout(pango_cairo_create_layout(cr));
  PangoContext* context = pango_layout_get_context(layout.get());
  pango_context_set_round_glyph_positions(context, FALSE);  // letters on whole points are badly spaced
  const std::unique_ptr<cairo_font_options_t, FontOptionsDeleter> options(cairo_font_options_create());
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);  // a PDF's, whatever is drawn on
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  pango_cairo_context_set_font_options(context, options.get());
  const std::unique_ptr<PangoFontDescription, FontDeleter> font(pango_font_description_from_string("Roboto, DejaVu Sans"));
  pango_font_description_set_absolute_size(font.get(), size_pt * PANGO_SCALE);
  pango_font_description_set_weight(font.get(), bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_layout_set_font_description(layout.get(), font.get());
  pango_layout_set_text(layout.get(), text.c_str(), static_cast<int>(text.size()));
  const std::unique_ptr<PangoAttrList, AttributesDeleter> attributes(pango_attr_list_new());
  pango_attr_list_insert(attributes.get(), pango_attr_insert_hyphens_new(FALSE));  // a broken name or id has no hyphen
  pango_layout_set_attributes(layout.get(), attributes.get());
  return layout;
}

struct Size {
  double width = 0.0, height = 0.0;
};
Size size_of(PangoLayout* layout) {
  int width = 0, height = 0;
  pango_layout_get_size(layout, &width, &height);
  return {static_cast<double>(width) / PANGO_SCALE, static_cast<double>(height) / PANGO_SCALE};
}

void set_width(PangoLayout* layout, double width) {
  pango_layout_set_width(layout, static_cast<int>(std::ceil(width * PANGO_SCALE)));
  pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
}

/// Fills and strokes the current path.
void paint_path(cairo_t* cr, const std::string& fill, const std::string& stroke, double opacity, double width) {
  if (!fill.empty()) {
    set_color(cr, fill, opacity);
    cairo_fill_preserve(cr);
  }
  if (!stroke.empty()) {
    set_color(cr, stroke);
    cairo_set_line_width(cr, width);
    cairo_stroke_preserve(cr);
  }
  cairo_new_path(cr);
}

void paint(cairo_t* cr, const DrawRect& r) {
  cairo_rectangle(cr, r.x, r.y, r.width, r.height);
  paint_path(cr, r.fill, "", r.opacity, 0.0);
}

void paint(cairo_t* cr, const DrawLine& l) {
  const double dashes[] = {4.0, 3.0};
  cairo_set_dash(cr, dashes, l.dashed ? 2 : 0, 0.0);
  cairo_move_to(cr, l.from.x, l.from.y);
  cairo_line_to(cr, l.to.x, l.to.y);
  paint_path(cr, "", l.stroke, 1.0, l.width);
  cairo_set_dash(cr, nullptr, 0, 0.0);
}

void paint(cairo_t* cr, const DrawCircle& c) {
  cairo_new_sub_path(cr);
  cairo_arc(cr, c.center.x, c.center.y, c.radius, 0.0, 2.0 * std::numbers::pi);
  paint_path(cr, c.fill, c.stroke, c.opacity, 1.0);
  if (!c.crossed) return;
  const double d = c.radius * 0.71;
  paint(cr, DrawLine{{c.center.x - d, c.center.y - d}, {c.center.x + d, c.center.y + d}, c.stroke, 1.0, false});
  paint(cr, DrawLine{{c.center.x - d, c.center.y + d}, {c.center.x + d, c.center.y - d}, c.stroke, 1.0, false});
}

void paint(cairo_t* cr, const DrawPolygon& p) {
  for (const DrawPoint& corner : p.corners) cairo_line_to(cr, corner.x, corner.y);
  cairo_close_path(cr);
  paint_path(cr, p.fill, p.stroke, 1.0, 1.0);
}

void paint(cairo_t* cr, const DrawText& t) {
  const Layout layout = layout_of(cr, t.text, t.size, t.bold);
  const double baseline = static_cast<double>(pango_layout_get_baseline(layout.get())) / PANGO_SCALE;
  const double width = size_of(layout.get()).width;
  cairo_save(cr);
  cairo_translate(cr, t.at.x, t.at.y);
  if (t.upwards) cairo_rotate(cr, -std::numbers::pi / 2.0);
  cairo_move_to(cr, t.anchor == TextAnchor::start ? 0.0 : t.anchor == TextAnchor::middle ? -width / 2.0 : -width, -baseline);
  set_color(cr, t.fill);
  pango_cairo_show_layout(cr, layout.get());
  cairo_restore(cr);
}

std::string creation_date() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now = epoch != nullptr ? static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10)) : std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

struct PdfCanvas::Impl {
  std::string bytes;  ///< outlives the surface, which writes into it
  Surface surface;
  Context cr;
  std::unique_ptr<RecordedPages::Impl> kept;  ///< none for a PDF

  void begin_kept_page() {
    const cairo_rectangle_t page{0.0, 0.0, page_width, page_height};
    surface.reset(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &page));
    cr.reset(cairo_create(surface.get()));
  }
};

PdfCanvas::PdfCanvas() : impl_(std::make_unique<Impl>()) {
  impl_->kept = std::make_unique<RecordedPages::Impl>();
  impl_->begin_kept_page();
}

PdfCanvas::PdfCanvas(const std::string& title, const std::string& software) : impl_(std::make_unique<Impl>()) {
  const auto take = [](void* into, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(into)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  };
  impl_->surface.reset(cairo_pdf_surface_create_for_stream(take, &impl_->bytes, page_width, page_height));
  cairo_surface_t* surface = impl_->surface.get();
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, software.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, creation_date().c_str());
  impl_->cr.reset(cairo_create(surface));
}

PdfCanvas::~PdfCanvas() = default;

void PdfCanvas::end_page() {
  if (!impl_->kept) return cairo_show_page(impl_->cr.get());
  impl_->cr.reset();
  impl_->kept->surfaces.push_back(std::move(impl_->surface));
  impl_->begin_kept_page();
}

RecordedPages PdfCanvas::take_pages() { return RecordedPages(impl_->kept ? std::move(impl_->kept) : std::make_unique<RecordedPages::Impl>()); }

std::optional<std::string> PdfCanvas::finish() {
  const bool drawn = cairo_status(impl_->cr.get()) == CAIRO_STATUS_SUCCESS;
  cairo_surface_finish(impl_->surface.get());
  if (!drawn || cairo_surface_status(impl_->surface.get()) != CAIRO_STATUS_SUCCESS) return std::nullopt;
  return std::move(impl_->bytes);
}

double PdfCanvas::text_width(const std::string& text, const TextStyle& style) {
  return size_of(layout_of(impl_->cr.get(), text, style.size_pt, style.bold).get()).width;
}

double PdfCanvas::word_width(const std::string& text, const TextStyle& style) {
  double widest = 0.0;
  std::istringstream words(text);
  for (std::string word; words >> word;) widest = std::max(widest, text_width(word, style));
  return widest;
}

double PdfCanvas::text_height(const std::string& text, const TextStyle& style, double width) {
  const Layout layout = layout_of(impl_->cr.get(), text, style.size_pt, style.bold);
  set_width(layout.get(), width);
  return size_of(layout.get()).height;
}

double PdfCanvas::text(double x, double y, double width, const std::string& text, const TextStyle& style, TextAnchor anchor) {
  cairo_t* cr = impl_->cr.get();
  const Layout layout = layout_of(cr, text, style.size_pt, style.bold);
  set_width(layout.get(), width);
  const PangoAlignment alignments[] = {PANGO_ALIGN_LEFT, PANGO_ALIGN_CENTER, PANGO_ALIGN_RIGHT};
  pango_layout_set_alignment(layout.get(), alignments[static_cast<int>(anchor)]);
  set_color(cr, style.color);
  cairo_move_to(cr, x, y);
  pango_cairo_show_layout(cr, layout.get());
  cairo_new_path(cr);
  return size_of(layout.get()).height;
}

void PdfCanvas::rule(double x, double y, double width, const std::string& color, double thickness) {
  cairo_move_to(impl_->cr.get(), x, y);
  cairo_line_to(impl_->cr.get(), x + width, y);
  paint_path(impl_->cr.get(), "", color, 1.0, thickness);
}

void PdfCanvas::fill(double x, double y, double width, double height, const std::string& color, double radius) {
  cairo_t* cr = impl_->cr.get();
  constexpr double quarter = std::numbers::pi / 2.0;
  cairo_new_sub_path(cr);
  cairo_arc(cr, x + width - radius, y + radius, radius, -quarter, 0.0);
  cairo_arc(cr, x + width - radius, y + height - radius, radius, 0.0, quarter);
  cairo_arc(cr, x + radius, y + height - radius, radius, quarter, 2.0 * quarter);
  cairo_arc(cr, x + radius, y + radius, radius, 2.0 * quarter, 3.0 * quarter);
  cairo_close_path(cr);
  paint_path(cr, color, "", 1.0, 0.0);
}

void PdfCanvas::draw(const Drawing& drawing, double x, double y, double scale) {
  cairo_t* cr = impl_->cr.get();
  cairo_save(cr);
  cairo_translate(cr, x, y);
  cairo_scale(cr, scale, scale);
  for (const DrawItem& item : drawing.items) std::visit([cr](const auto& one) { paint(cr, one); }, item);
  cairo_restore(cr);
}

void PdfCanvas::bookmark(const std::string& title, int page) {
  if (impl_->kept) return;
  cairo_pdf_surface_add_outline(impl_->surface.get(), CAIRO_PDF_OUTLINE_ROOT, title.c_str(), ("page=" + std::to_string(page)).c_str(),
                                CAIRO_PDF_OUTLINE_FLAG_OPEN);
}

}  // namespace stemwise
