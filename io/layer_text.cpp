#include "io/layer_text.hpp"

#include <algorithm>

#include "io/exact_number.hpp"

namespace stemwise {
namespace {

std::string number_text(double value, int decimals, bool decimal_comma) {
  std::string text = fixed_text(value, decimals);
  if (decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::string value_text(const LayerValue& value, const LayerColumn& column, const TextTableStyle& style) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return text_field(number_text(*number, column.decimals, style.decimal_comma), style.delimiter);
  if (const auto* text = std::get_if<std::string>(&value)) return text_field(*text, style.delimiter);
  return {};
}

std::string polygon_wkt(const LayerFeature& feature) {
  std::string text = "POLYGON ((";
  for (std::size_t i = 0; i <= feature.corners.size(); ++i) {
    const auto& c = feature.corners[i % feature.corners.size()];
    text += (i > 0 ? ", " : "") + exact_text(c.x()) + " " + exact_text(c.y());
  }
  return text + "))";
}

}  // namespace

std::string text_field(const std::string& text, char delimiter) {
  const bool plain = text.find_first_of(std::string("\"\r\n") + delimiter) == std::string::npos && !text.starts_with(' ') && !text.ends_with(' ');
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string layer_text(const Layer& layer, const TextTableStyle& style) {
  const bool with_wkt = layer.geometry == LayerGeometry::polygon;
  std::string text;
  for (std::size_t i = 0; i < layer.columns.size(); ++i) {
    if (i > 0) text += style.delimiter;
    text += text_field(layer.columns[i].name, style.delimiter);
  }
  if (with_wkt) text += std::string(1, style.delimiter) + "wkt";
  text += '\n';
  for (const LayerFeature& feature : layer.features) {
    for (std::size_t i = 0; i < layer.columns.size(); ++i) {
      if (i > 0) text += style.delimiter;
      text += value_text(feature.values[i], layer.columns[i], style);
    }
    if (with_wkt) text += style.delimiter + text_field(polygon_wkt(feature), style.delimiter);
    text += '\n';
  }
  return text;
}

}  // namespace stemwise
