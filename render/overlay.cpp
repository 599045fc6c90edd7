#include "render/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "render/number_text.hpp"

namespace stemwise::render {
namespace {

constexpr double margin = 14.0;
constexpr std::size_t most_rings = 3000;
constexpr int most_labels = 160;

/// Works in interface pixels (100 %): the canvas is scaled, projections are divided.
class OverlayPainter {
 public:
  OverlayPainter(const SceneModel& scene, const Projection& projection, const ViewOptions& options, const Canvas& canvas)
      : scene_(scene), view_(projection), options_(options), canvas_(canvas), colours_(theme_colours(options.theme)),
        width_(projection.size.width / projection.px_scale), height_(projection.size.height / projection.px_scale) {}

  void paint() const {
    captions();
    if (options_.labels) labels();
    selection();
    if (options_.scale_bar && view_.kind == ViewKind::map) scale_bar();
    if (options_.north_arrow) north_arrow();
    if (options_.legend && !scene_.empty()) legend();
    if (view_.kind == ViewKind::map) extra_keys();
    if (!options_.title.empty()) title();
  }

 private:
  std::optional<Eigen::Vector2d> at(const Eigen::Vector3d& world_m) const {
    const auto pixel = view_.pixels_of(world_m);
    if (!pixel) return std::nullopt;
    return Eigen::Vector2d(*pixel / view_.px_scale);
  }

  void panel(double x, double y, double width, double height) const {
    canvas_.rounded(x + 0.5, y + 0.5, width - 1.0, height - 1.0, 6.0);
    canvas_.fill(colours_.panel);
    canvas_.rounded(x + 0.5, y + 0.5, width - 1.0, height - 1.0, 6.0);
    canvas_.stroke(colours_.line, 1.0);
  }

  /// What stands side by side, each with its name above; names that would meet stand in rows above each other.
  void captions() const {
    struct Row {
      double from, to, y;
    };
    std::vector<Row> taken;
    for (const SideFrame& frame : scene_.side_frames) {
      const auto place = at({frame.low_m.x(), frame.high_m.y(), 0.0});
      if (!place || place->x() >= width_) continue;
      const TextStyle words{12.5, Weight::semibold, frame.colour, Align::left, colours_.map};
      const double width = canvas_.text_width(frame.caption, words);
      const double x = std::max(margin, std::min(place->x(), width_ - margin - width));
      double y = place->y() - 22.0;
      const auto meets = [&](const Row& other) { return x < other.to + 10.0 && other.from < x + width + 10.0 && std::abs(other.y - y) < 15.0; };
      while (std::any_of(taken.begin(), taken.end(), meets)) y -= 17.0;
      taken.push_back({x, x + width, y});
      canvas_.text(x, y, frame.caption, words);
    }
  }

  void labels() const {
    if (options_.moving || view_.kind != ViewKind::map) return;
    const double spacing_px = scene_.spacing_m / view_.map.metres_per_px / view_.px_scale;
    if (spacing_px < 40.0) return;  // nearer to each other than that labels would lie over the circles of others
    std::vector<const Mark*> seen;
    for (const Mark& mark : scene_.marks) {
      const Eigen::Vector2d pixel = view_.map.pixels_of(mark.base_m.head<2>(), view_.size);
      if (mark.tree && view_.is_inside(pixel)) seen.push_back(&mark);
    }
    std::stable_sort(seen.begin(), seen.end(), [](const Mark* a, const Mark* b) { return a->dbh_m > b->dbh_m; });
    std::vector<Eigen::Vector2d> taken;
    std::unordered_set<TreeId> done;
    int drawn = 0;
    for (const Mark* mark : seen) {
      if (drawn >= most_labels) break;
      drawn += label(*mark, taken, done);
    }
  }

  /// One label below its circle, unless another one is there.
  int label(const Mark& mark, std::vector<Eigen::Vector2d>& taken, std::unordered_set<TreeId>& done) const {
    if (done.contains(mark.tree)) return 0;
    const auto shape = view_.shape_of(mark);
    const double x = shape->base_px.x() / view_.px_scale, y = (shape->base_px.y() + shape->radius_px) / view_.px_scale + 10.0;
    for (const Eigen::Vector2d& other : taken)
      if (std::abs(other.x() - x) < 54.0 && std::abs(other.y() - y) < 15.0) return 0;
    taken.emplace_back(x, y);
    done.insert(mark.tree);
    canvas_.text(x, y, tree_label(mark.tree), {11.0, Weight::regular, colours_.secondary, Align::centre, colours_.map.with_alpha(0.85)});
    return 1;
  }

  void ring(const Mark& mark, Rgba colour, double width, double gap) const {
    const auto shape = view_.shape_of(mark);
    if (!shape) return;
    const Eigen::Vector2d base = shape->base_px / view_.px_scale, top = shape->top_px / view_.px_scale;
    const double radius = shape->radius_px / view_.px_scale;
    if (view_.kind == ViewKind::map) {
      canvas_.circle(base.x(), base.y(), radius + gap);
      canvas_.stroke(colours_.map.with_alpha(0.8), width + 2.0);
      canvas_.circle(base.x(), base.y(), radius + gap);
      canvas_.stroke(colour, width);
      return;
    }
    const Eigen::Vector2d along = (top - base).norm() > 1e-6 ? Eigen::Vector2d((top - base).normalized()) : Eigen::Vector2d(0.0, -1.0);
    const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()) * (radius + 0.6 * gap);
    cairo_t* cr = canvas_.cairo();
    for (const bool is_halo : {true, false}) {
      cairo_move_to(cr, base.x() - side.x(), base.y() - side.y());
      for (const Eigen::Vector2d& p : {Eigen::Vector2d(top - side), Eigen::Vector2d(top + side), Eigen::Vector2d(base + side)})
        cairo_line_to(cr, p.x(), p.y());
      cairo_close_path(cr);
      canvas_.stroke(is_halo ? colours_.map.with_alpha(0.7) : colour, is_halo ? width + 2.0 : width);
    }
  }

  void selection() const {
    std::size_t rings = 0;
    const bool is_group = options_.selected.size() > 1;  // close to the stems, so that many do not hide what they are around
    for (const TreeId tree : options_.selected) {
      const Mark* mark = scene_.find(tree);
      if (mark && rings++ < most_rings) ring(*mark, colours_.text, is_group ? 1.4 : 2.4, is_group ? 2.5 : 6.0);
    }
    if (options_.selected.size() == 1) doubt(options_.selected.front());
    for (const StemRef stem : options_.selected_stems) {
      const Mark* mark = scene_.find(stem);
      if (mark && rings++ < most_rings) ring(*mark, colours_.text, 2.4, 6.0);
    }
    if (const Mark* mark = scene_.find(options_.hovered)) ring(*mark, colours_.accent, 1.6, 3.5);
  }

  /// The other stem that this tree could have been: a dashed ring and a dashed line to it.
  void doubt(TreeId tree) const {
    const Mark* mark = scene_.find(tree);
    const auto other = scene_.alternative_of_tree.find(tree);
    if (!mark || other == scene_.alternative_of_tree.end()) return;
    const auto from = at(mark->base_m), to = at(other->second);
    if (!from || !to) return;
    cairo_t* cr = canvas_.cairo();
    cairo_save(cr);
    constexpr double dashes[] = {3.0, 2.5};
    cairo_set_dash(cr, dashes, 2, 0.0);
    canvas_.line(from->x(), from->y(), to->x(), to->y(), colours_.warning, 1.6);
    if (view_.kind == ViewKind::map) {
      canvas_.circle(from->x(), from->y(), view_.shape_of(*mark)->radius_px / view_.px_scale + 10.0);
      canvas_.stroke(colours_.warning, 1.4);
    }
    cairo_restore(cr);
    canvas_.circle(to->x(), to->y(), 2.4);
    canvas_.fill(colours_.warning);
  }

  void scale_bar() const {
    const double metres_per_px = view_.map.metres_per_px * view_.px_scale;
    const double length_m = scale_bar_m(metres_per_px, 110.0);
    const double bar = length_m / metres_per_px;
    const double width = bar + 24.0, x = width_ - margin - width, y = height_ - margin - 34.0;
    panel(x, y, width, 34.0);
    canvas_.text(x + 0.5 * width, y + 13.0, length_text(length_m), {12.0, Weight::regular, colours_.text, Align::centre});
    canvas_.line(x + 12.0, y + 24.0, x + 12.0 + bar, y + 24.0, colours_.text, 2.0);
  }

  void north_arrow() const {
    const double turn = view_.kind == ViewKind::map ? 0.0 : view_.orbit.azimuth_rad;
    const double azimuth = -scene_.north_azimuth_rad.value_or(0.0) - turn;  // of the arrow on the screen, clockwise from up
    cairo_t* cr = canvas_.cairo();
    cairo_save(cr);
    cairo_translate(cr, width_ - margin - 18.0, margin + 18.0);
    cairo_rotate(cr, azimuth);
    cairo_move_to(cr, 0.0, -13.0);
    cairo_line_to(cr, 7.5, 11.0);
    cairo_line_to(cr, 0.0, 5.5);
    cairo_line_to(cr, -7.5, 11.0);
    cairo_close_path(cr);
    canvas_.fill(colours_.text);
    cairo_restore(cr);
    const char* words = scene_.north_azimuth_rad ? "N" : "+y";
    canvas_.text(width_ - margin - 18.0, margin + 43.0, words, {12.0, Weight::bold, colours_.text, Align::centre, colours_.map.with_alpha(0.8)});
  }

  void legend_mark(double x, double y, const LegendEntry& entry) const {
    constexpr double r = 5.0;
    cairo_t* cr = canvas_.cairo();
    const auto outline = [&] {
      if (entry.shape == MarkShape::diamond) {
        cairo_move_to(cr, x, y - r * 1.2);
        cairo_line_to(cr, x + r * 1.2, y);
        cairo_line_to(cr, x, y + r * 1.2);
        cairo_line_to(cr, x - r * 1.2, y);
        cairo_close_path(cr);
      } else if (entry.shape == MarkShape::square) {
        cairo_rectangle(cr, x - 0.85 * r, y - 0.85 * r, 1.7 * r, 1.7 * r);
      } else {
        canvas_.circle(x, y, r);
      }
    };
    outline();
    canvas_.fill(entry.colour.with_alpha(entry.shape == MarkShape::hollow ? 0.08 : entry.shape == MarkShape::solid_cross ? 0.7 : 0.4));
    outline();
    canvas_.stroke(entry.colour, 1.4);
    const double d = entry.shape == MarkShape::square ? 0.75 * r : r;
    if (entry.shape == MarkShape::cross || entry.shape == MarkShape::solid_cross || entry.shape == MarkShape::square) {
      canvas_.line(x - d, y - d, x + d, y + d, entry.colour, 1.4);
      canvas_.line(x - d, y + d, x + d, y - d, entry.colour, 1.4);
    } else if (entry.shape == MarkShape::plus) {
      canvas_.line(x - 0.5 * r, y, x + 0.5 * r, y, entry.colour, 1.4);
      canvas_.line(x, y - 0.5 * r, x, y + 0.5 * r, entry.colour, 1.4);
    } else if (entry.shape == MarkShape::ring) {
      canvas_.circle(x, y, 0.45 * r);
      canvas_.stroke(entry.colour, 1.2);
    }
  }

  void legend() const {
    const Legend& key = scene_.legend;
    const TextStyle body{12.0, Weight::regular, colours_.text, Align::left};
    const TextStyle number{12.0, Weight::regular, colours_.secondary, Align::right};
    const std::string heading = key.unit.empty() ? key.title : key.title + ", " + key.unit;
    double width = std::max(96.0, canvas_.text_width(heading, {12.0, Weight::semibold, colours_.text, Align::left}) + 24.0);
    for (const LegendEntry& entry : key.entries) {
      const double count = entry.count ? canvas_.text_width(grouped_text(*entry.count), number) + 18.0 : 0.0;
      width = std::max(width, 24.0 + 20.0 + canvas_.text_width(entry.label, body) + count);
    }
    if (!key.gradient.empty()) width = std::max(width, 210.0);
    const double gradient = key.gradient.empty() ? 0.0 : 36.0;
    const double height = 34.0 + gradient + 20.0 * static_cast<double>(key.entries.size()) + (key.entries.empty() ? 2.0 : 4.0);
    const double x = margin;
    double y = height_ - margin - height;
    panel(x, y, width, height);
    canvas_.text(x + 12.0, y + 17.0, heading, {12.0, Weight::semibold, colours_.text, Align::left});
    y += 34.0;
    if (!key.gradient.empty()) legend_gradient(key, x + 14.0, y, width - 28.0);
    y += gradient;
    for (const LegendEntry& entry : key.entries) {
      legend_mark(x + 18.0, y + 8.0, entry);
      canvas_.text(x + 32.0, y + 8.0, entry.label, body);
      if (entry.count) canvas_.text(x + width - 12.0, y + 8.0, grouped_text(*entry.count), number);
      y += 20.0;
    }
  }

  /// Above the scale bar: the heat map's colours, and how much the residual arrows are lengthened.
  void extra_keys() const {
    double bottom = height_ - margin - (options_.scale_bar ? 42.0 : 0.0);
    if (const Legend& key = scene_.heat_legend; !key.title.empty()) {
      const double width = 210.0, x = width_ - margin - width;
      const double height = 70.0 + 18.0 * static_cast<double>(key.entries.size());
      bottom -= height;
      panel(x, bottom, width, height);
      const std::string heading = key.unit.empty() ? key.title : key.title + ", " + key.unit;
      canvas_.text(x + 12.0, bottom + 17.0, heading, {12.0, Weight::semibold, colours_.text, Align::left});
      legend_gradient(key, x + 16.0, bottom + 33.0, width - 32.0);
      for (std::size_t i = 0; i < key.entries.size(); ++i)
        canvas_.text(x + 12.0, bottom + 74.0 + 18.0 * static_cast<double>(i), key.entries[i].label, {11.0, Weight::regular, colours_.secondary, Align::left});
      bottom -= 8.0;
    }
    if (!options_.residuals || scene_.links.empty()) return;
    const std::string words = "Residuals, " + number_text(scene_.residual_factor, 0) + " times as long";
    const TextStyle style{12.0, Weight::regular, colours_.text, Align::left};
    const double width = canvas_.text_width(words, style) + 48.0, x = width_ - margin - width;
    panel(x, bottom - 28.0, width, 28.0);
    canvas_.line(x + 12.0, bottom - 14.0, x + 28.0, bottom - 14.0, colours_.warning, 1.6);
    canvas_.text(x + 36.0, bottom - 14.0, words, style);
  }

  void legend_gradient(const Legend& key, double x, double y, double width) const {
    cairo_pattern_t* pattern = cairo_pattern_create_linear(x, 0.0, x + width, 0.0);
    const double last = static_cast<double>(key.gradient.size() - 1);
    for (std::size_t i = 0; i < key.gradient.size(); ++i) {
      const Rgba c = key.gradient[i];
      cairo_pattern_add_color_stop_rgb(pattern, static_cast<double>(i) / last, c.r / 255.0, c.g / 255.0, c.b / 255.0);
    }
    canvas_.rounded(x, y, width, 10.0, 3.0);
    cairo_set_source(canvas_.cairo(), pattern);
    cairo_fill(canvas_.cairo());
    cairo_pattern_destroy(pattern);
    const TextStyle words{11.0, Weight::regular, colours_.secondary, Align::centre};
    for (const LegendTick& tick : key.ticks) {
      // The outermost numbers stay inside the panel.
      const double half = 0.5 * canvas_.text_width(tick.label, words), low = x + half - 5.0, high = x + width - half + 5.0;
      canvas_.text(std::clamp(x + tick.at * width, low, std::max(low, high)), y + 21.0, tick.label, words);
    }
  }

  void title() const {
    canvas_.text(margin + 2.0, margin + 12.0, options_.title, {17.0, Weight::semibold, colours_.text, Align::left, colours_.map.with_alpha(0.85)});
  }

  const SceneModel& scene_;
  const Projection& view_;
  const ViewOptions& options_;
  const Canvas& canvas_;
  const ThemeColours& colours_;
  double width_, height_;
};

}  // namespace

double scale_bar_m(double metres_per_px, double most_px) {
  const double most_m = metres_per_px * most_px;
  const double step = nice_step(most_m);
  if (step <= most_m * (1.0 + 1e-9)) return step;
  const double power = std::pow(10.0, std::floor(std::log10(most_m)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most_m) return factor * power;
  return power;
}

std::string length_text(double length_m) {
  if (length_m >= 1000.0) return number_text(length_m / 1000.0, 0) + " km";
  if (length_m >= 1.0) return number_text(length_m, 0) + " m";
  return length_m >= 0.01 ? number_text(length_m * 100.0, 0) + " cm" : number_text(length_m * 1000.0, 0) + " mm";
}

void paint_overlay(const Canvas& canvas, const SceneModel& scene, const Projection& projection, const ViewOptions& options) {
  OverlayPainter(scene, projection, options, canvas).paint();
}

}  // namespace stemwise::render
