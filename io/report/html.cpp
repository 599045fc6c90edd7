#include "io/report/print_text.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

// spec/ui.md, light theme. Prints well too: sections keep their tables whole where they fit.
constexpr const char* style = R"(
:root{--text:#1E2A23;--secondary:#5E6E65;--line:#D8DDD5;--grid:#E9EDE7;--accent:#2A7A4C;--soft:#E3F0E8;--panel:#F3F5F1;--warning:#B26A00}
*{box-sizing:border-box}
body{margin:0;background:var(--panel);color:var(--text);font:14px/1.5 Roboto,"DejaVu Sans",system-ui,sans-serif}
main{max-width:1080px;margin:0 auto;padding:40px 48px;background:#fff;min-height:100vh}
header{border-bottom:2px solid var(--accent);padding-bottom:16px;margin-bottom:24px}
h1{font-size:26px;font-weight:600;margin:0}
header p{color:var(--secondary);margin:4px 0 0}
h2{font-size:18px;font-weight:600;margin:40px 0 12px}
h3{font-size:14px;font-weight:600;margin:24px 0 8px}
p.warning{border-left:3px solid var(--warning);padding-left:12px;color:var(--warning)}
.figures{display:flex;flex-wrap:wrap;gap:16px;margin:16px 0}
.figures div{flex:1 1 150px;background:var(--soft);border-radius:6px;padding:14px 16px}
.figures b{display:block;font-size:24px;font-weight:600;color:var(--accent);line-height:1.2}
.figures span{display:block;font-weight:500}
.figures small{color:var(--secondary)}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:12.5px;font-variant-numeric:tabular-nums}
th{text-align:left;font-weight:500;color:var(--secondary);border-bottom:1px solid var(--secondary);padding:6px 10px 6px 0;vertical-align:bottom}
td{border-bottom:1px solid var(--grid);padding:5px 10px 5px 0;vertical-align:top}
th.n,td.n{text-align:right;white-space:nowrap}
td:not(.n){overflow-wrap:anywhere}
p.note,figcaption{font-size:11.5px;color:var(--secondary);margin:8px 0 0}
figure{margin:24px 0;break-inside:avoid}
figure svg{width:100%;max-width:760px;height:auto;font-family:Roboto,"DejaVu Sans",system-ui,sans-serif}
dl{display:grid;grid-template-columns:max-content 1fr;gap:4px 20px;font-size:13px}
dt{color:var(--secondary)}
dd{margin:0}
footer{margin-top:48px;padding-top:12px;border-top:1px solid var(--line);font-size:11.5px;color:var(--secondary)}
@media print{body{background:#fff}main{padding:0;max-width:none}h2,h3{break-after:avoid}tr{break-inside:avoid}thead{display:table-header-group}}
)";

std::string block_html(const ReportParagraph& paragraph) {
  return std::string(paragraph.is_warning ? "<p class=\"warning\">" : "<p>") + escape_markup(print_prose(paragraph.text)) + "</p>\n";
}

std::string block_html(const ReportFigures& figures) {
  std::string html = "<div class=\"figures\">";
  for (const ReportFigure& f : figures) {
    html += "<div><b>" + escape_markup(print_number(f.value)) + "</b><span>" + escape_markup(f.label) + "</span><small>" +
            escape_markup(print_prose(f.detail)) + "</small></div>";
  }
  return html + "</div>\n";
}

std::string row_html(const ReportTable& table, const std::vector<std::string>& row) {
  std::string html = "<tr>";
  for (std::size_t c = 0; c < row.size(); ++c) {
    const bool is_number = table.columns[c].is_number;
    html += (is_number ? "<td class=\"n\">" : "<td>") + escape_markup(is_number ? print_number(row[c]) : row[c]) + "</td>";
  }
  return html + "</tr>\n";
}

std::string block_html(const ReportTable& table) {
  std::string html = "<h3>" + escape_markup(table.title) + "</h3>\n";
  if (table.rows.empty()) return html + "<p>None.</p>\n";
  html += "<div class=\"scroll\"><table><thead><tr>";
  for (const ReportColumn& column : table.columns) {
    html += (column.is_number ? "<th class=\"n\">" : "<th>") + escape_markup(print_prose(column.name)) + "</th>";
  }
  html += "</tr></thead><tbody>\n";
  const std::size_t shown = table.printed_rows == 0 ? table.rows.size() : std::min(table.printed_rows, table.rows.size());
  for (std::size_t r = 0; r < shown; ++r) html += row_html(table, table.rows[r]);
  html += "</tbody></table></div>\n";
  if (shown < table.rows.size()) {
    html += "<p class=\"note\">The first " + std::to_string(shown) + " of " + std::to_string(table.rows.size()) + "; the CSV report has all of them.</p>\n";
  }
  return html + (table.note.empty() ? "" : "<p class=\"note\">" + escape_markup(print_prose(table.note)) + "</p>\n");
}

std::string block_html(const ReportChart& chart) {
  return "<figure>\n" + to_svg(chart.drawing) + "<figcaption>" + escape_markup(print_prose(chart.caption)) + "</figcaption></figure>\n";
}

std::string cover_html(const ReportCover& cover) {
  std::string html = cover.figures.empty() ? "" : block_html(cover.figures);
  if (cover.map) html += block_html(*cover.map);
  if (cover.facts.empty()) return html;
  html += "<dl>";
  for (const auto& [label, text] : cover.facts) html += "<dt>" + escape_markup(label) + "</dt><dd>" + escape_markup(print_prose(text)) + "</dd>";
  return html + "</dl>\n";
}

}  // namespace

std::string report_html(const ReportDocument& document) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
                     escape_markup(document.title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<main>\n<header><h1>" +
                     escape_markup(document.title) + "</h1><p>" + escape_markup(document.subtitle) + "</p></header>\n" + cover_html(document.cover);
  for (const ReportSection& section : document.sections) {
    html += "<section>\n<h2>" + escape_markup(section.title) + "</h2>\n";
    for (const ReportBlock& block : section.blocks) {
      html += std::visit([](const auto& one) { return block_html(one); }, block);
    }
    html += "</section>\n";
  }
  return html + "<footer>" + escape_markup(document.footer) + "</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace stemwise
