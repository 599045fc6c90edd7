#include "io/delimited_text.hpp"

namespace stemwise {
namespace {

constexpr std::int64_t max_lines_of_a_field = 100;

/// Walks over the text field by field, counting lines as an editor does.
class Splitter {
 public:
  Splitter(std::string_view text, char delimiter) : text_(text), delimiter_(delimiter) {}

  bool done() const { return at_ >= text_.size(); }

  GridRow next_row() {
    GridRow row{line_, {}};
    if (delimiter_ == ' ') skip_blanks();
    while (true) {
      row.cells.push_back(next_field());
      if (done()) return row;
      if (text_[at_] == '\n' || text_[at_] == '\r') {
        end_line();
        return row;
      }
      ++at_;  // the delimiter
      if (delimiter_ != ' ') continue;
      skip_blanks();
      if (!done() && (text_[at_] == '\n' || text_[at_] == '\r')) {
        end_line();
        return row;
      }
      if (done()) return row;
    }
  }

 private:
  bool is_delimiter(char c) const { return c == delimiter_ || (delimiter_ == ' ' && c == '\t'); }

  void skip_blanks() {
    while (!done() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  void end_line() {
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
    ++at_;
    ++line_;
  }

  std::string next_field() {
    std::size_t start = at_;
    while (start < text_.size() && text_[start] == ' ' && delimiter_ != ' ') ++start;
    if (start < text_.size() && text_[start] == '"') {
      std::string field;
      if (quoted(start, field)) return std::string(trimmed(field));
    }
    const std::size_t from = at_;
    while (!done() && !is_delimiter(text_[at_]) && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    return std::string(trimmed(text_.substr(from, at_ - from)));
  }

  /// Reads the quoted field whose opening quote is at `start`; false, with nothing consumed, when it is never closed.
  bool quoted(std::size_t start, std::string& field) {
    std::size_t i = start + 1;
    std::int64_t lines = 0;
    while (i < text_.size()) {
      const char c = text_[i];
      if (c == '"') {
        if (i + 1 >= text_.size() || text_[i + 1] != '"') break;
        ++i;
      }
      if (c == '\n' || (c == '\r' && (i + 1 >= text_.size() || text_[i + 1] != '\n'))) {
        if (++lines > max_lines_of_a_field) return false;
      }
      field.push_back(c);
      ++i;
    }
    if (i >= text_.size()) return false;
    ++i;  // the closing quote; whatever stands between it and the delimiter belongs to the field
    while (i < text_.size() && !is_delimiter(text_[i]) && text_[i] != '\n' && text_[i] != '\r') field.push_back(text_[i++]);
    at_ = i;
    line_ += lines;
    return true;
  }

  std::string_view text_;
  char delimiter_;
  std::size_t at_ = 0;
  std::int64_t line_ = 1;
};

bool has_text(const GridRow& row) {
  for (const std::string& cell : row.cells) {
    if (!cell.empty()) return true;
  }
  return false;
}

}  // namespace

Grid parse_delimited(std::string_view text, char delimiter, std::size_t max_rows) {
  Grid grid;
  Splitter splitter(text, delimiter);
  while (!splitter.done() && grid.rows.size() < max_rows) {
    GridRow row = splitter.next_row();
    if (has_text(row)) grid.rows.push_back(std::move(row));
  }
  return grid;
}

std::string delimiter_name(char delimiter) {
  switch (delimiter) {
    case ',': return "comma";
    case ';': return "semicolon";
    case '\t': return "tab";
    case '|': return "vertical bar";
    default: return "blanks";
  }
}

std::string_view trimmed(std::string_view text) {
  const auto strip = [&text](std::string_view blank) {
    bool any = false;
    while (text.starts_with(blank)) text.remove_prefix(blank.size()), any = true;
    while (text.ends_with(blank)) text.remove_suffix(blank.size()), any = true;
    return any;
  };
  while (strip(" ") || strip("\t") || strip("\r") || strip("\n") || strip("\xC2\xA0")) {
  }
  return text;
}

}  // namespace stemwise
