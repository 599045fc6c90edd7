#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "io/report/drawing.hpp"
#include "io/report/print_text.hpp"
#include "io/report/write_report.hpp"
#include "io/zip_file.hpp"

namespace stemwise {
namespace {

// Office Open XML (ECMA-376), the least of it: one sheet per table, inline strings, seven cell styles.

enum Style { plain = 0, title = 1, head = 2, note = 3, head_right = 4, warning = 5, first_number = 6 };  // 6..10: 0 to 4 decimals
constexpr int most_decimals = 4;

constexpr const char* xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";

std::string styles_xml() {
  std::string formats, cells;
  for (int d = 0; d <= most_decimals; ++d) {
    formats += "<numFmt numFmtId=\"" + std::to_string(170 + d) + "\" formatCode=\"0" + (d == 0 ? "" : "." + std::string(static_cast<std::size_t>(d), '0')) + "\"/>";
    cells += "<xf numFmtId=\"" + std::to_string(170 + d) + "\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyNumberFormat=\"1\"/>";
  }
  return std::string(xml_head) +
         "<styleSheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><numFmts count=\"5\">" + formats +
         "</numFmts><fonts count=\"4\"><font><sz val=\"10\"/><name val=\"Calibri\"/></font><font><b/><sz val=\"14\"/><color rgb=\"FF2A7A4C\"/><name val=\"Calibri\"/></font>"
         "<font><b/><sz val=\"10\"/><name val=\"Calibri\"/></font><font><i/><sz val=\"9\"/><color rgb=\"FF5E6E65\"/><name val=\"Calibri\"/></font></fonts>"
         "<fills count=\"3\"><fill><patternFill patternType=\"none\"/></fill><fill><patternFill patternType=\"gray125\"/></fill>"
         "<fill><patternFill patternType=\"solid\"><fgColor rgb=\"FFE3F0E8\"/></patternFill></fill></fills>"
         "<borders count=\"2\"><border><left/><right/><top/><bottom/><diagonal/></border><border><left/><right/><top/><bottom style=\"thin\"><color rgb=\"FF5E6E65\"/></bottom><diagonal/></border></borders>"
         "<cellStyleXfs count=\"1\"><xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\"/></cellStyleXfs><cellXfs count=\"11\">"
         "<xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\"/><xf numFmtId=\"0\" fontId=\"1\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyFont=\"1\"/>"
         "<xf numFmtId=\"0\" fontId=\"2\" fillId=\"2\" borderId=\"1\" xfId=\"0\" applyFont=\"1\" applyFill=\"1\" applyBorder=\"1\" applyAlignment=\"1\"><alignment wrapText=\"1\" vertical=\"bottom\"/></xf>"
         "<xf numFmtId=\"0\" fontId=\"3\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyFont=\"1\" applyAlignment=\"1\"><alignment wrapText=\"1\" vertical=\"top\"/></xf>"
         "<xf numFmtId=\"0\" fontId=\"2\" fillId=\"2\" borderId=\"1\" xfId=\"0\" applyFont=\"1\" applyFill=\"1\" applyBorder=\"1\" applyAlignment=\"1\"><alignment horizontal=\"right\" wrapText=\"1\" vertical=\"bottom\"/></xf>"
         "<xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyAlignment=\"1\"><alignment wrapText=\"1\" vertical=\"top\"/></xf>" +
         cells + "</cellXfs></styleSheet>";
}

std::string column_name(std::size_t column) {
  std::string name;
  for (std::size_t n = column + 1; n > 0; n = (n - 1) / 26) name.insert(name.begin(), static_cast<char>('A' + (n - 1) % 26));
  return name;
}

std::string text_cell(std::size_t column, std::size_t row, const std::string& text, int style) {
  return "<c r=\"" + column_name(column) + std::to_string(row) + "\" s=\"" + std::to_string(style) + "\" t=\"inlineStr\"><is><t xml:space=\"preserve\">" +
         escape_markup(text) + "</t></is></c>";
}

/// A cell that is a number as it stands: its value is written as it is, with as many decimals as it has.
std::optional<int> decimals_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || text.find_first_of("eE") != std::string::npos) return std::nullopt;
  const std::size_t point = text.find('.');
  return std::min(most_decimals, point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1));
}

std::string cell(std::size_t column, std::size_t row, const std::string& text, bool is_number) {
  if (text.empty()) return "";
  const auto decimals = is_number ? decimals_of(text) : std::nullopt;
  if (!decimals) return text_cell(column, row, text, plain);
  return "<c r=\"" + column_name(column) + std::to_string(row) + "\" s=\"" + std::to_string(first_number + *decimals) + "\"><v>" + text + "</v></c>";
}

std::string row_xml(std::size_t row, const std::string& cells) { return "<row r=\"" + std::to_string(row) + "\">" + cells + "</row>"; }

std::string sheet_xml(const std::string& rows, const std::vector<double>& widths, std::size_t frozen_rows, const std::string& merges, const std::string& footer) {
  std::string columns;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    char width[24];
    *std::to_chars(width, width + sizeof width - 1, widths[c], std::chars_format::fixed, 1).ptr = 0;
    columns += "<col min=\"" + std::to_string(c + 1) + "\" max=\"" + std::to_string(c + 1) + "\" width=\"" + width + "\" customWidth=\"1\"/>";
  }
  const std::string pane = frozen_rows == 0 ? ""
                                            : "<pane ySplit=\"" + std::to_string(frozen_rows) + "\" topLeftCell=\"A" + std::to_string(frozen_rows + 1) +
                                                  "\" activePane=\"bottomLeft\" state=\"frozen\"/>";
  return std::string(xml_head) + "<worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetPr><pageSetUpPr fitToPage=\"1\"/></sheetPr><sheetViews><sheetView workbookViewId=\"0\">" +
         pane + "</sheetView></sheetViews><cols>" + columns + "</cols><sheetData>" + rows + "</sheetData>" + merges +
         "<pageMargins left=\"0.6\" right=\"0.6\" top=\"0.7\" bottom=\"0.7\" header=\"0.3\" footer=\"0.3\"/><pageSetup paperSize=\"9\" orientation=\"landscape\" fitToHeight=\"0\"/>"
         "<headerFooter><oddFooter>&amp;L" + escape_markup(footer) + "&amp;R&amp;A, page &amp;P of &amp;N</oddFooter></headerFooter></worksheet>";
}

std::size_t printed_length(const std::string& utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The longest word of the head and the longest cell, within reason.
std::vector<double> widths_of(const ReportTable& table) {
  std::vector<double> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t most = 8;
    const std::string& name = table.columns[c].name;
    for (std::size_t from = 0; from < name.size();) {
      const std::size_t to = std::min(name.find(' ', from), name.size());
      most = std::max(most, to - from);
      from = to + 1;
    }
    for (const auto& row : table.rows) most = std::max(most, printed_length(row[c]));
    widths.push_back(std::min(60.0, static_cast<double>(most) + 2.0));
  }
  return widths;
}

std::string table_sheet(const ReportTable& table, const std::string& footer) {
  std::string rows = row_xml(1, text_cell(0, 1, table.title, title));
  std::string names;
  for (std::size_t c = 0; c < table.columns.size(); ++c) names += text_cell(c, 3, table.columns[c].name, table.columns[c].is_number ? head_right : head);
  rows += row_xml(3, names);
  std::size_t at = 4;
  for (const auto& row : table.rows) {
    std::string cells;
    for (std::size_t c = 0; c < row.size(); ++c) cells += cell(c, at, row[c], table.columns[c].is_number);
    rows += row_xml(at++, cells);
  }
  std::string merges;
  std::vector<double> widths = widths_of(table);
  if (!table.note.empty()) {
    double total = 0.0;
    for (const double width : widths) total += width;
    const double lines = 1.0 + static_cast<double>(table.note.size()) / std::max(20.0, total * 1.05);
    ++at;
    rows += "<row r=\"" + std::to_string(at) + "\" ht=\"" + std::to_string(static_cast<int>(13.0 * lines + 6.0)) + "\" customHeight=\"1\">" + text_cell(0, at, table.note, note) + "</row>";
    if (table.columns.size() > 1) merges = "<mergeCells count=\"1\"><mergeCell ref=\"A" + std::to_string(at) + ":" + column_name(table.columns.size() - 1) + std::to_string(at) + "\"/></mergeCells>";
  }
  return sheet_xml(rows, widths, 3, merges, footer);
}

/// The first sheet: what is no table.
std::string cover_sheet(const ReportDocument& document) {
  std::string rows = row_xml(1, text_cell(0, 1, document.title, title)) + row_xml(2, text_cell(0, 2, document.subtitle, plain));
  std::size_t at = 4;
  for (const ReportFigure& f : document.cover.figures) {
    rows += row_xml(at, text_cell(0, at, f.label, plain) + text_cell(1, at, f.value, plain) + text_cell(2, at, f.detail, plain));
    ++at;
  }
  for (const auto& [label, text] : document.cover.facts) {
    rows += row_xml(at, text_cell(0, at, label, plain) + text_cell(2, at, text, warning));
    ++at;
  }
  for (const ReportSection& section : document.sections)
    for (const ReportBlock& block : section.blocks) {
      if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) {
        rows += row_xml(at, text_cell(0, at, section.title, plain) + text_cell(1, at, "", plain) + text_cell(2, at, paragraph->text, warning));
        ++at;
      }
    }
  rows += row_xml(at + 1, text_cell(0, at + 1, document.footer, note));
  return sheet_xml(rows, {30.0, 16.0, 100.0}, 0, "", document.title);
}

/// At most 31 characters, none that a sheet's name may not have, each once.
std::string sheet_name(const std::string& title, std::map<std::string, int>& taken) {
  std::string name;
  for (const char c : title) name += std::string_view("[]:*?/\\").find(c) == std::string_view::npos ? c : ' ';
  if (name.size() > 28) name.resize(28);
  while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0x80) != 0) name.pop_back();
  const int n = ++taken[name];
  return n == 1 ? name : name + " " + std::to_string(n);
}

}  // namespace

Result<Done> write_report_xlsx(const std::string& path, const ReportDocument& document) {
  std::map<std::string, int> taken;
  std::vector<std::pair<std::string, std::string>> sheets = {{sheet_name("Summary", taken), cover_sheet(document)}};
  for (const ReportSection& section : document.sections)
    for (const ReportBlock& block : section.blocks)
      if (const auto* table = std::get_if<ReportTable>(&block); table != nullptr && !table->rows.empty())
        sheets.emplace_back(sheet_name(table->title, taken), table_sheet(*table, document.title));
  std::string types, list, relations;
  std::vector<ZipEntry> files;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    types += "<Override PartName=\"/xl/worksheets/sheet" + n + ".xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/>";
    list += "<sheet name=\"" + escape_markup(sheets[i].first) + "\" sheetId=\"" + n + "\" r:id=\"rId" + n + "\"/>";
    relations += "<Relationship Id=\"rId" + n + "\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet\" Target=\"worksheets/sheet" + n + ".xml\"/>";
    files.push_back({"xl/worksheets/sheet" + n + ".xml", sheets[i].second});
  }
  const std::string relationships = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">";
  files.insert(files.begin(),
               {{"[Content_Types].xml", std::string(xml_head) + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
                                        "<Default Extension=\"xml\" ContentType=\"application/xml\"/><Override PartName=\"/xl/workbook.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/>"
                                        "<Override PartName=\"/xl/styles.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.styles+xml\"/>" + types + "</Types>"},
                {"_rels/.rels", std::string(xml_head) + relationships + "<Relationship Id=\"rId1\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"},
                {"xl/workbook.xml", std::string(xml_head) + "<workbook xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\" xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\"><sheets>" + list + "</sheets></workbook>"},
                {"xl/_rels/workbook.xml.rels", std::string(xml_head) + relationships + relations + "<Relationship Id=\"rId" + std::to_string(sheets.size() + 1) +
                                                   "\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships/styles\" Target=\"styles.xml\"/></Relationships>"},
                {"xl/styles.xml", styles_xml()}});
  return write_zip(path, files);
}

}  // namespace stemwise
