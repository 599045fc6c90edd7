#include "render/paint/chart_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "render/number_text.hpp"

namespace stemwise::render {
namespace {

constexpr double tick_size = 11.5;
constexpr double px_per_x_tick = 46.0, px_per_y_tick = 32.0;  ///< at least, between ticks

/// One chart on one canvas; lengths in interface pixels.
class ChartPainter {
 public:
  ChartPainter(const Canvas& canvas, const ChartModel& chart, double width, double height, const ChartStyle& style)
      : canvas_(canvas), chart_(chart), style_(style), colours_(theme_colours(style.theme)), width_(width), height_(height),
        selected_(style.selected.begin(), style.selected.end()) {}

  ChartLayout paint() {
    if (!style_.is_transparent) {
      cairo_rectangle(canvas_.cairo(), 0.0, 0.0, width_, height_);
      canvas_.fill(colours_.panel);
    }
    place();
    const double end = heading(true);
    if (!chart_.empty_text.empty()) {
      canvas_.paragraph(16.0, end + 8.0, width_ - 32.0, chart_.empty_text, {12.5, Weight::regular, colours_.secondary, Align::left}, true);
      return layout_;
    }
    if (!chart_.petals.empty()) {
      rose();
      return layout_;
    }
    bands();
    grid();
    clip(true);
    bars();
    rules();
    points();
    boxes();
    clip(false);
    axes();
    labels();
    return layout_;
  }

 private:
  TextStyle tick_style(Align align) const { return {tick_size, Weight::regular, colours_.secondary, align}; }
  double x_px(double value) const { return layout_.pixel_of({value, 0.0}).x(); }
  double y_px(double value) const { return layout_.pixel_of({0.0, value}).y(); }

  std::vector<double> ticks_of(const ChartAxis& axis, double length_px, double px_per_tick) const {
    if (!axis.ticks.empty()) return axis.ticks;
    const bool is_count = axis.unit.empty();
    double step = nice_step((axis.high - axis.low) * px_per_tick / std::max(40.0, length_px));
    if (is_count) step = std::max(1.0, step);
    std::vector<double> ticks;
    for (double at = std::ceil(axis.low / step - 1e-9) * step; at <= axis.high + 1e-9 * step; at += step) ticks.push_back(at);
    return ticks;
  }

  std::string tick_text(const ChartAxis& axis, const std::vector<double>& ticks, std::size_t i) const {
    if (i < axis.tick_labels.size()) return axis.tick_labels[i];
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
    return axis.unit.empty() ? grouped_text(std::llround(ticks[i])) : number_text(ticks[i], decimals_of(step));
  }

  bool has_legend() const { return chart_.bars.size() > 1 || (chart_.points.size() > 1); }

  /// Title, note and key, each wrapped to the width; returns where they end.
  double heading(bool is_drawn) const {
    const double width = width_ - 32.0;
    double y = 10.0;
    if (style_.has_title && !chart_.title.empty())
      y += canvas_.paragraph(16.0, y, width, chart_.title, {14.0, Weight::semibold, colours_.text, Align::left}, is_drawn) + 2.0;
    if (!chart_.note.empty())
      y += canvas_.paragraph(16.0, y, width, chart_.note, {11.5, Weight::regular, colours_.secondary, Align::left}, is_drawn) + 4.0;
    return has_legend() ? key(y, is_drawn) : y;
  }

  double key(double y, bool is_drawn) const {
    const TextStyle words{11.5, Weight::regular, colours_.text, Align::left};
    double x = 16.0;
    const auto entry = [&](const std::string& name, Rgba colour) {
      const double width = 15.0 + canvas_.text_width(name, words);
      if (x > 16.0 && x + width > width_ - 12.0) {
        x = 16.0;
        y += 18.0;
      }
      if (is_drawn) {
        canvas_.circle(x + 5.0, y + 9.0, 4.5);
        canvas_.fill(colour);
        canvas_.text(x + 15.0, y + 9.0, name, words);
      }
      x += width + 16.0;
    };
    for (const ChartBars& series : chart_.bars) entry(series.name, chart_colour(series.colour, style_.theme));
    for (const ChartPoints& series : chart_.points) entry(series.name, chart_colour(series.colour, style_.theme));
    return y + 22.0;
  }

  void place() {
    double top = heading(false) + 6.0;
    if (std::any_of(chart_.rules.begin(), chart_.rules.end(), [](const ChartRule& rule) { return rule.is_on_x && !rule.label.empty(); })) top += 14.0;
    if (!chart_.petals.empty()) return place_square(top);
    const std::vector<double> ticks = ticks_of(chart_.y, height_ - top - 40.0, px_per_y_tick);
    double widest = 10.0;
    for (std::size_t i = 0; i < ticks.size(); ++i) widest = std::max(widest, canvas_.text_width(tick_text(chart_.y, ticks, i), tick_style(Align::right)));
    const double bottom = chart_.x.title.empty() ? 26.0 : 44.0;
    layout_.low_px = {16.0 + widest + (chart_.y.title.empty() ? 0.0 : 20.0), top};
    layout_.high_px = {width_ - 16.0, std::max(top + 20.0, height_ - bottom)};
    layout_.low = {chart_.x.low, chart_.y.low};
    layout_.high = {chart_.x.high, chart_.y.high};
  }

  /// As large as there is room for, in the middle.
  void place_square(double top) {
    const double side = std::max(20.0, std::min(width_ - 32.0, height_ - top - 10.0)), left = 0.5 * (width_ - side);
    layout_.low_px = {left, top};
    layout_.high_px = {left + side, top + side};
    layout_.low = {chart_.x.low, chart_.y.low};
    layout_.high = {chart_.x.high, chart_.y.high};
  }

  void rose() const {
    cairo_t* cr = canvas_.cairo();
    const double x = x_px(0.0), y = y_px(0.0), unit = x_px(1.0) - x;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {  // of the longest petal's count
      canvas_.circle(x, y, unit * std::sqrt(share));
      canvas_.stroke(colours_.line, 1.0);
    }
    canvas_.line(x - unit, y, x + unit, y, colours_.line, 1.0);
    canvas_.line(x, y - unit, x, y + unit, colours_.line, 1.0);
    for (const ChartPetal& petal : chart_.petals) {
      if (petal.radius <= 0.0) continue;
      const auto outline = [&] {
        cairo_move_to(cr, x, y);
        cairo_arc(cr, x, y, unit * petal.radius, petal.from_rad + 0.015 - 1.5707963267948966, petal.to_rad - 0.015 - 1.5707963267948966);
        cairo_close_path(cr);
      };
      outline();
      canvas_.fill(colours_.accent.with_alpha(0.62));
      if (std::none_of(petal.trees.begin(), petal.trees.end(), [this](TreeId tree) { return selected_.contains(tree); })) continue;
      outline();
      canvas_.stroke(colours_.text, 1.8);
    }
    canvas_.text(x, y - unit - 9.0, "+y", tick_style(Align::centre));
    canvas_.text(x + unit + 6.0, y, "+x", tick_style(Align::left));
  }

  void clip(bool is_on) const {
    cairo_t* cr = canvas_.cairo();
    if (!is_on) return cairo_restore(cr);
    cairo_save(cr);
    cairo_rectangle(cr, layout_.low_px.x(), layout_.low_px.y() - 1.0, layout_.high_px.x() - layout_.low_px.x(), layout_.high_px.y() - layout_.low_px.y() + 1.0);
    cairo_clip(cr);
  }

  void bands() const {
    for (const ChartBand& band : chart_.bands) {
      const double low = std::clamp(band.low, band.is_on_x ? chart_.x.low : chart_.y.low, band.is_on_x ? chart_.x.high : chart_.y.high);
      const double high = std::clamp(band.high, band.is_on_x ? chart_.x.low : chart_.y.low, band.is_on_x ? chart_.x.high : chart_.y.high);
      if (band.is_on_x) {
        cairo_rectangle(canvas_.cairo(), x_px(low), layout_.low_px.y(), x_px(high) - x_px(low), layout_.high_px.y() - layout_.low_px.y());
      } else {
        cairo_rectangle(canvas_.cairo(), layout_.low_px.x(), y_px(high), layout_.high_px.x() - layout_.low_px.x(), y_px(low) - y_px(high));
      }
      const bool is_neutral = band.colour.ink == ChartInk::within_error;
      canvas_.fill(is_neutral ? mix(colours_.panel, colours_.line, 0.55) : colours_.accent_soft);
    }
  }

  void grid() const {
    for (const double tick : ticks_of(chart_.y, layout_.high_px.y() - layout_.low_px.y(), px_per_y_tick)) {
      const double y = std::round(y_px(tick)) + 0.5;
      canvas_.line(layout_.low_px.x(), y, layout_.high_px.x(), y, colours_.line.with_alpha(0.8), 1.0);
    }
  }

  bool is_selected(const ChartBar& bar) const {
    return !selected_.empty() && std::any_of(bar.trees.begin(), bar.trees.end(), [this](TreeId tree) { return selected_.contains(tree); });
  }

  void bars() const {
    for (const ChartBars& series : chart_.bars) {
      const Rgba colour = chart_colour(series.colour, style_.theme);
      for (const ChartBar& bar : series.bars) {
        if (bar.value <= 0.0) continue;
        const double gap = chart_.bars.size() > 1 ? 0.5 : 1.0;
        const double left = x_px(bar.x_low) + gap, right = std::max(left + 0.8, x_px(bar.x_high) - gap), top = y_px(bar.value);
        cairo_rectangle(canvas_.cairo(), left, top, right - left, layout_.high_px.y() - top);
        canvas_.fill(colour.with_alpha(chart_.bars.size() > 1 ? 0.88 : 0.62));
        if (!is_selected(bar)) continue;
        cairo_rectangle(canvas_.cairo(), left, top, right - left, layout_.high_px.y() - top);
        canvas_.stroke(colours_.text, 2.0);
      }
    }
  }

  void rules() const {
    for (const ChartRule& rule : chart_.rules) {
      const Rgba colour = rule.is_strong ? colours_.text : colours_.secondary;
      const double width = rule.is_strong ? 1.5 : 1.0;
      if (rule.is_on_x) {
        canvas_.line(x_px(rule.at), layout_.low_px.y(), x_px(rule.at), layout_.high_px.y(), colour, width);
      } else {
        canvas_.line(layout_.low_px.x(), y_px(rule.at), layout_.high_px.x(), y_px(rule.at), colour, width);
      }
    }
  }

  void points() const {
    for (const ChartPoints& series : chart_.points) {
      const Rgba colour = chart_colour(series.colour, style_.theme);
      if (series.is_joined) {
        joined(series, colour);
        continue;
      }
      const double radius = series.points.size() > 3000 ? 1.5 : series.points.size() > 400 ? 2.1 : 2.8;
      for (const ChartPoint& point : series.points) {
        canvas_.circle(x_px(point.x), y_px(point.y), radius);
        canvas_.fill(colour.with_alpha(0.55));
      }
    }
    for (const ChartPoints& series : chart_.points)
      for (const ChartPoint& point : series.points)
        if (!series.is_joined && selected_.contains(point.tree)) {
          canvas_.circle(x_px(point.x), y_px(point.y), 5.0);
          canvas_.stroke(colours_.text, 1.8);
        }
  }

  void joined(const ChartPoints& series, Rgba colour) const {
    cairo_t* cr = canvas_.cairo();
    for (const ChartPoint& point : series.points)
      if (point.y_error > 0.0) canvas_.line(x_px(point.x), y_px(point.y - point.y_error), x_px(point.x), y_px(point.y + point.y_error), colour, 1.6);
    for (const ChartPoint& point : series.points) cairo_line_to(cr, x_px(point.x), y_px(point.y));
    canvas_.stroke(colour, 1.8);
    if (!series.has_marks) return;
    for (const ChartPoint& point : series.points) {
      canvas_.circle(x_px(point.x), y_px(point.y), 4.5);
      canvas_.fill(colours_.panel);
      canvas_.circle(x_px(point.x), y_px(point.y), 4.5);
      canvas_.stroke(colour, 1.8);
    }
  }

  void boxes() const {
    for (const ChartBox& box : chart_.boxes) {
      const Rgba colour = chart_colour(box.colour, style_.theme);
      const double left = x_px(box.x - 0.5 * box.width), right = x_px(box.x + 0.5 * box.width), middle = x_px(box.x);
      for (const auto& [end, edge] : {std::pair(box.whisker_low, box.low), std::pair(box.whisker_high, box.high)}) {
        canvas_.line(middle, y_px(end), middle, y_px(edge), colour, 1.4);
        canvas_.line(0.5 * (left + middle), y_px(end), 0.5 * (right + middle), y_px(end), colour, 1.4);
      }
      cairo_rectangle(canvas_.cairo(), left, y_px(box.high), right - left, y_px(box.low) - y_px(box.high));
      canvas_.fill(colour.with_alpha(0.35));
      cairo_rectangle(canvas_.cairo(), left, y_px(box.high), right - left, y_px(box.low) - y_px(box.high));
      canvas_.stroke(colour, 1.4);
      canvas_.line(left, y_px(box.median), right, y_px(box.median), colours_.text, 2.0);
    }
  }

  void axes() const {
    const std::vector<double> xs = ticks_of(chart_.x, layout_.high_px.x() - layout_.low_px.x(), px_per_x_tick);
    for (std::size_t i = 0; i < xs.size(); ++i)
      canvas_.text(x_px(xs[i]), layout_.high_px.y() + 14.0, tick_text(chart_.x, xs, i), tick_style(Align::centre));
    const std::vector<double> ys = ticks_of(chart_.y, layout_.high_px.y() - layout_.low_px.y(), px_per_y_tick);
    for (std::size_t i = 0; i < ys.size(); ++i) canvas_.text(layout_.low_px.x() - 8.0, y_px(ys[i]), tick_text(chart_.y, ys, i), tick_style(Align::right));
    canvas_.line(layout_.low_px.x(), layout_.high_px.y() + 0.5, layout_.high_px.x(), layout_.high_px.y() + 0.5, colours_.faint, 1.0);
    const auto with_unit = [](const ChartAxis& axis) { return axis.title + (axis.unit.empty() ? "" : ", " + axis.unit) + (axis.note.empty() ? "" : "; " + axis.note); };
    if (!chart_.x.title.empty())
      canvas_.text(0.5 * (layout_.low_px.x() + layout_.high_px.x()), layout_.high_px.y() + 33.0, with_unit(chart_.x), tick_style(Align::centre));
    if (chart_.y.title.empty()) return;
    cairo_t* cr = canvas_.cairo();
    cairo_save(cr);
    cairo_translate(cr, 14.0, 0.5 * (layout_.low_px.y() + layout_.high_px.y()));
    cairo_rotate(cr, -1.5707963267948966);
    canvas_.text(0.0, 0.0, with_unit(chart_.y), tick_style(Align::centre));
    cairo_restore(cr);
  }

  /// Words at rules stand above the plot, words of bands inside it at the edge: they never cover bars' tops.
  void labels() const {
    for (const ChartRule& rule : chart_.rules)
      if (!rule.label.empty() && rule.is_on_x) {
        const double half = 0.5 * canvas_.text_width(rule.label, {11.5, Weight::semibold, colours_.text, Align::centre});
        const double x = std::clamp(x_px(rule.at), layout_.low_px.x() + half, layout_.high_px.x() - half);
        canvas_.text(x, layout_.low_px.y() - 9.0, rule.label, {11.5, Weight::semibold, colours_.text, Align::centre});
      }
    for (const ChartBand& band : chart_.bands) {
      const TextStyle words{11.0, Weight::regular, colours_.secondary, Align::right, (band.is_on_x ? colours_.accent_soft : colours_.panel).with_alpha(0.7)};
      if (band.is_on_x) {
        band_label_on_x(band, words);
      } else {
        canvas_.text(layout_.high_px.x() - 6.0, y_px(std::min(band.high, chart_.y.high)) + 9.0, band.label, words);
      }
    }
  }

  /// In the line of the rules' words above the plot, where those leave room: nothing lies under it there.
  bool band_label_above(const ChartBand& band, TextStyle words, double right, double width) const {
    double from = layout_.low_px.x();
    bool has_words = false;
    for (const ChartRule& rule : chart_.rules) {
      if (!rule.is_on_x || rule.label.empty()) continue;
      const double half = 0.5 * canvas_.text_width(rule.label, {11.5, Weight::semibold, colours_.text, Align::centre});
      from = std::max(from, std::clamp(x_px(rule.at), layout_.low_px.x() + half, layout_.high_px.x() - half) + half + 10.0);
      has_words = true;
    }
    const double end = std::max(right, from + width);
    if (!has_words || end > layout_.high_px.x()) return false;
    words.halo = {0, 0, 0, 0};
    canvas_.text(end, layout_.low_px.y() - 9.0, band.label, words);
    return true;
  }

  /// At the right edge of its band, or beside it where a rule would run through the words.
  void band_label_on_x(const ChartBand& band, TextStyle words) const {
    const double right = x_px(std::min(band.high, chart_.x.high)) - 5.0;
    const double width = canvas_.text_width(band.label, words), y = layout_.low_px.y() + 10.0;
    if (band_label_above(band, words, right, width)) return;
    const auto crosses = [&](const ChartRule& rule) { return rule.is_on_x && x_px(rule.at) > right - width - 4.0 && x_px(rule.at) < right + 4.0; };
    const bool room_beside = right + 10.0 + width < layout_.high_px.x();
    if (!room_beside || std::none_of(chart_.rules.begin(), chart_.rules.end(), crosses)) {
      canvas_.text(right, y, band.label, words);
      return;
    }
    words.align = Align::left;
    words.halo = colours_.panel.with_alpha(0.7);
    canvas_.text(right + 10.0, y, band.label, words);
  }

  const Canvas& canvas_;
  const ChartModel& chart_;
  const ChartStyle& style_;
  const ThemeColours& colours_;
  double width_, height_;
  std::unordered_set<TreeId> selected_;
  ChartLayout layout_;
};

}  // namespace

Rgba chart_colour(const ChartColour& colour, Theme theme) {
  switch (colour.ink) {
    case ChartInk::accent: return theme_colours(theme).accent;
    case ChartInk::survey: return survey_colour(colour.survey);
    case ChartInk::warning: return theme_colours(theme).warning;
    case ChartInk::secondary: return theme_colours(theme).secondary;
    case ChartInk::grew: return purple_white_orange(0.85, theme);
    case ChartInk::shrank: return purple_white_orange(-0.85, theme);
    case ChartInk::within_error: return neutral_grey(theme);
  }
  return theme_colours(theme).accent;
}

ChartLayout paint_chart_on(const Canvas& canvas, const ChartModel& chart, double width, double height, const ChartStyle& style) {
  return ChartPainter(canvas, chart, width, height, style).paint();
}

}  // namespace stemwise::render
