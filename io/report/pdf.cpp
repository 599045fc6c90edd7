#include <algorithm>

#include "io/report/palette.hpp"
#include "io/report/pdf_canvas.hpp"
#include "io/report/pdf_table.hpp"
#include "io/report/print_text.hpp"
#include "io/report/recorded_pages.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

constexpr double margin = 50.0;
constexpr double content_width = PdfCanvas::page_width - 2.0 * margin;
constexpr double content_bottom = PdfCanvas::page_height - 62.0;

constexpr double fact_gap = 8.0;

const TextStyle cover_title_style{26.0, palette::text, true};
const TextStyle subtitle_style{10.0, palette::secondary, false};
const TextStyle section_style{14.0, palette::text, true};
const TextStyle table_title_style{10.0, palette::text, true};
const TextStyle body_style{9.0, palette::text, false};
const TextStyle label_style{9.0, palette::secondary, false};
const TextStyle warning_style{9.0, palette::warning, false};
const TextStyle figure_style{15.0, palette::accent, true};
const TextStyle figure_label_style{7.5, palette::text, true};
const TextStyle figure_detail_style{6.5, palette::secondary, false};
const TextStyle note_style{7.5, palette::secondary, false};

using Fact = std::pair<std::string, std::string>;  ///< label and text

/// Lays the document out on pages. Pass 1 counts the pages (they are thrown away with the canvas), pass 2 prints "1 of 7".
class PdfReport {
 public:
  PdfReport(PdfCanvas& canvas, const ReportDocument& document, int pages) : canvas_(canvas), document_(document), pages_(pages) {}

  int print() {
    print_cover();
    for (const ReportSection& section : document_.sections) print_section(section);
    finish_page();
    return page_;
  }

 private:
  /// Title, key figures, the map in what room there is, and the facts at its foot.
  void print_cover() {
    const ReportCover& cover = document_.cover;
    canvas_.fill(0.0, 0.0, PdfCanvas::page_width, 8.0, palette::accent);
    canvas_.bookmark(document_.title, page_);
    y_ = margin + 14.0;
    y_ += canvas_.text(margin, y_, content_width, print_prose(document_.title), cover_title_style) + 4.0;
    y_ += canvas_.text(margin, y_, content_width, document_.subtitle, subtitle_style) + 14.0;
    if (!cover.figures.empty()) print_block(cover.figures);
    y_ += 6.0;
    measure_fact_labels(cover.facts);
    double facts = 0.0;
    for (const Fact& fact : cover.facts) facts += fact_height(fact);
    constexpr double least_map = 240.0;  // rather the facts on the next page than a map that nobody can read
    const bool together = content_bottom - facts - 16.0 - y_ >= least_map;
    if (cover.map) print_map(*cover.map, together ? content_bottom - facts - 16.0 : content_bottom);
    if (cover.facts.empty()) return;
    need(std::min(facts + 16.0, least_map));
    canvas_.rule(margin, y_, content_width, palette::line);
    y_ += 8.0;
    for (const Fact& fact : cover.facts) print_fact(fact);
    finish_page();
    ++page_;
    y_ = margin;
  }

  /// Labels stand on one line where three fifths of the width allow it.
  void measure_fact_labels(const std::vector<Fact>& facts) {
    constexpr double least = 110.0;
    for (const Fact& fact : facts) fact_label_ = std::max(fact_label_, canvas_.text_width(fact.first, label_style) + fact_gap + 1.0);
    fact_label_ = std::clamp(fact_label_, least, 0.6 * content_width);
  }

  double fact_height(const Fact& fact) {
    const double label = canvas_.text_height(fact.first, label_style, fact_label_ - fact_gap);
    return std::max(label, canvas_.text_height(print_prose(fact.second), body_style, content_width - fact_label_)) + 3.0;
  }

  void print_fact(const Fact& fact) {
    const double height = fact_height(fact);
    need(height);
    canvas_.text(margin, y_, fact_label_ - fact_gap, fact.first, label_style);
    canvas_.text(margin + fact_label_, y_, content_width - fact_label_, print_prose(fact.second), body_style);
    y_ += height;
  }

  void print_map(const ReportChart& map, double bottom) {
    const double caption = canvas_.text_height(print_prose(map.caption), note_style, content_width);
    const double room = bottom - y_ - caption - 10.0;
    if (room < 80.0) return;
    const double scale = std::min(content_width / map.drawing.width, room / map.drawing.height);
    canvas_.draw(map.drawing, margin + 0.5 * (content_width - map.drawing.width * scale), y_, scale);
    y_ += map.drawing.height * scale + 4.0;
    y_ += canvas_.text(margin, y_, content_width, print_prose(map.caption), note_style) + 10.0;
  }

  void print_section(const ReportSection& section) {
    need(150.0);  // a heading does not stand alone at the foot of a page
    if (y_ > margin) y_ += 16.0;
    canvas_.bookmark(section.title, page_);
    y_ += canvas_.text(margin, y_, content_width, section.title, section_style) + 6.0;
    for (const ReportBlock& block : section.blocks) {
      std::visit([this](const auto& one) { print_block(one); }, block);
    }
  }

  void print_block(const ReportParagraph& paragraph) {
    const std::string text = print_prose(paragraph.text);
    const TextStyle& style = paragraph.is_warning ? warning_style : body_style;
    need(canvas_.text_height(text, style, content_width) + 6.0);
    y_ += canvas_.text(margin, y_, content_width, text, style) + 6.0;
  }

  double figure_height(const ReportFigure& f, double inner) {
    return canvas_.text_height(print_number(f.value), figure_style, inner) + 1.0 + canvas_.text_height(f.label, figure_label_style, inner) +
           canvas_.text_height(print_prose(f.detail), figure_detail_style, inner);
  }

  /// Cards side by side, all as high as the one with most to say.
  void print_block(const ReportFigures& figures) {
    constexpr double least_height = 64.0, gap = 8.0, inset = 7.0;
    const double width = (content_width - gap * static_cast<double>(figures.size() - 1)) / static_cast<double>(figures.size());
    const double inner = width - 2.0 * inset;
    double height = least_height;
    for (const ReportFigure& f : figures) height = std::max(height, figure_height(f, inner) + 2.0 * inset);
    need(height + 8.0);
    double x = margin;
    for (const ReportFigure& f : figures) {
      canvas_.fill(x, y_, width, height, palette::accent_soft, 4.0);
      double y = y_ + inset;
      y += canvas_.text(x + inset, y, inner, print_number(f.value), figure_style) + 1.0;
      y += canvas_.text(x + inset, y, inner, f.label, figure_label_style);
      canvas_.text(x + inset, y, inner, print_prose(f.detail), figure_detail_style);
      x += width + gap;
    }
    y_ += height + 8.0;
  }

  void print_block(const ReportTable& table) {
    if (table.rows.empty()) {
      need(80.0);
      print_table_title(table);
      y_ += canvas_.text(margin, y_, content_width, "None.", body_style) + 6.0;
      return;
    }
    const std::vector<TablePart> parts = fit_table(canvas_, table, content_width);
    double rows = 0.0;  // a title does not stand without the head and the first rows
    for (std::size_t row = 0; row < std::min<std::size_t>(3, table.rows.size()); ++row) rows += table_row_height(canvas_, table, parts.front(), row);
    need(30.0 + table_head_height(canvas_, table, parts.front()) + rows);
    print_table_title(table);
    for (const TablePart& part : parts) print_part(table, part);
    print_note(table);
  }

  void print_table_title(const ReportTable& table) {
    y_ += 6.0;
    y_ += canvas_.text(margin, y_, content_width, table.title, table_title_style) + 2.0;
  }

  void print_part(const ReportTable& table, const TablePart& part) {
    const double head = table_head_height(canvas_, table, part);
    need(head + 2.0 * table_row_height(canvas_, table, part, 0));
    draw_table_head(canvas_, table, part, margin, y_);
    y_ += head;
    const std::size_t shown = table.printed_rows == 0 ? table.rows.size() : std::min(table.printed_rows, table.rows.size());
    for (std::size_t row = 0; row < shown; ++row) {
      const double height = table_row_height(canvas_, table, part, row);
      if (need(height)) {
        draw_table_head(canvas_, table, part, margin, y_);
        y_ += head;
      }
      draw_table_row(canvas_, table, part, row, margin, y_);
      y_ += height;
    }
    y_ += 5.0;
  }

  void print_note(const ReportTable& table) {
    std::string note = print_prose(table.note);
    if (table.printed_rows > 0 && table.printed_rows < table.rows.size()) {
      note = "The first " + std::to_string(table.printed_rows) + " of " + std::to_string(table.rows.size()) + "; the CSV report has all of them. " + note;
    }
    if (note.empty()) return;
    need(canvas_.text_height(note, note_style, content_width));
    y_ += canvas_.text(margin, y_, content_width, note, note_style) + 8.0;
  }

  void print_block(const ReportChart& chart) {
    const double caption = canvas_.text_height(print_prose(chart.caption), note_style, content_width);
    const double room = content_bottom - margin - caption - 12.0;
    const double scale = std::min(content_width / chart.drawing.width, room / chart.drawing.height);
    need(chart.drawing.height * scale + caption + 12.0);
    y_ += 4.0;
    canvas_.draw(chart.drawing, margin, y_, scale);
    y_ += chart.drawing.height * scale + 2.0;
    y_ += canvas_.text(margin, y_, content_width, print_prose(chart.caption), note_style) + 6.0;
  }

  /// Turns the page when less than `height` is left; true when it did.
  bool need(double height) {
    if (y_ + height <= content_bottom) return false;
    finish_page();
    ++page_;
    y_ = margin;
    return true;
  }

  void finish_page() {
    const double y = PdfCanvas::page_height - 40.0;
    canvas_.rule(margin, y - 6.0, content_width, palette::line);
    canvas_.text(margin, y, content_width * 0.75, print_prose(document_.title) + " \u00b7 " + document_.footer, note_style);
    canvas_.text(margin, y, content_width, std::to_string(page_) + " of " + std::to_string(pages_), note_style, TextAnchor::end);
    canvas_.end_page();
  }

  PdfCanvas& canvas_;
  const ReportDocument& document_;
  int pages_ = 0;
  int page_ = 1;
  double y_ = margin;
  double fact_label_ = 0.0;  ///< width of the cover's labels
};

int count_pages(const ReportDocument& document) {
  PdfCanvas counting;
  return PdfReport(counting, document, 0).print();
}

}  // namespace

std::optional<std::string> report_pdf(const ReportDocument& document) {
  PdfCanvas canvas(document.title, document.footer);
  PdfReport(canvas, document, count_pages(document)).print();
  return canvas.finish();
}

RecordedPages report_pages(const ReportDocument& document) {
  PdfCanvas canvas;
  PdfReport(canvas, document, count_pages(document)).print();
  return canvas.take_pages();
}

}  // namespace stemwise
