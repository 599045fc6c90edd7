#include "io/layer_style.hpp"

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/survey/fate.hpp"
#include "io/report/drawing.hpp"
#include "io/report/palette.hpp"

namespace stemwise {
namespace {

using Properties = std::vector<std::pair<std::string, std::string>>;

std::string rgba(const std::string& hex, int alpha) {
  unsigned r = 0, g = 0, b = 0;
  std::sscanf(hex.c_str(), "#%2x%2x%2x", &r, &g, &b);
  return std::to_string(r) + "," + std::to_string(g) + "," + std::to_string(b) + "," + std::to_string(alpha);
}

/// The size of a marker in millimetres, from the tree's diameter.
constexpr const char* size_by_dbh =
    "<data_defined_properties><Option type=\"Map\"><Option name=\"name\" type=\"QString\" value=\"\"/><Option name=\"properties\" type=\"Map\"><Option name=\"size\" type=\"Map\">"
    "<Option name=\"active\" type=\"bool\" value=\"true\"/><Option name=\"expression\" type=\"QString\" value=\"1.2 + coalesce(&quot;dbh_cm&quot;, 10) / 20\"/>"
    "<Option name=\"type\" type=\"int\" value=\"3\"/></Option></Option><Option name=\"type\" type=\"QString\" value=\"collection\"/></Option></data_defined_properties>";

std::string symbol(const std::string& name, const char* type, const char* layer_class, const Properties& properties, const std::string& data_defined = "") {
  std::string xml = "<symbol type=\"" + std::string(type) + "\" name=\"" + name + "\" alpha=\"1\" clip_to_extent=\"1\" force_rhr=\"0\"><layer class=\"" + layer_class +
                    "\" enabled=\"1\" locked=\"0\" pass=\"0\"><Option type=\"Map\">";
  for (const auto& [key, value] : properties) xml += "<Option name=\"" + key + "\" type=\"QString\" value=\"" + escape_markup(value) + "\"/>";
  return xml + "</Option>" + data_defined + "</layer></symbol>";
}

std::string marker(const std::string& name, const std::string& color, bool hollow, bool crossed) {
  return symbol(name, "marker", "SimpleMarker",
                {{"name", crossed ? "cross2" : "circle"}, {"color", rgba(color, hollow ? 0 : 115)}, {"outline_color", rgba(color, 255)}, {"outline_style", "solid"},
                 {"outline_width", "0.25"}, {"outline_width_unit", "MM"}, {"size", "2"}, {"size_unit", "MM"}},
                size_by_dbh);
}

struct Category {
  std::string value, label, color;
  bool hollow = false, crossed = false;
};

std::string categorised(const char* attribute, const std::vector<Category>& categories) {
  std::string list, symbols;
  for (std::size_t i = 0; i < categories.size(); ++i) {
    const Category& c = categories[i];
    list += "<category render=\"true\" symbol=\"" + std::to_string(i) + "\" value=\"" + escape_markup(c.value) + "\" label=\"" + escape_markup(c.label) + "\" type=\"string\"/>";
    symbols += marker(std::to_string(i), c.color, c.hollow, c.crossed);
  }
  return "<renderer-v2 type=\"categorizedSymbol\" attr=\"" + std::string(attribute) + "\" forceraster=\"0\" symbollevels=\"0\" enableorderby=\"0\"><categories>" + list +
         "</categories><symbols>" + symbols + "</symbols></renderer-v2>";
}

std::string single(const std::string& one) {
  return "<renderer-v2 type=\"singleSymbol\" forceraster=\"0\" symbollevels=\"0\" enableorderby=\"0\"><symbols>" + one + "</symbols></renderer-v2>";
}

std::vector<Category> fates() {
  std::vector<Category> out;
  for (std::size_t i = 0; i < fate_count; ++i) {
    const auto fate = static_cast<Fate>(i);
    out.push_back({to_string(fate), fate_label(fate), palette::fates[i], fate == Fate::outside_coverage, fate == Fate::missing});
  }
  return out;
}

std::vector<Category> inventories_in(OGRLayer& layer) {
  std::vector<Category> out;
  const int at = layer.GetLayerDefn()->GetFieldIndex("inventory");
  layer.ResetReading();
  for (FeaturePtr feature(layer.GetNextFeature()); feature; feature.reset(layer.GetNextFeature())) {
    const std::string name = feature->GetFieldAsString(at);
    bool is_new = true;
    for (const Category& c : out) is_new = is_new && c.value != name;
    if (is_new) out.push_back({name, name, palette::surveys[out.size() % palette::surveys.size()]});
  }
  layer.ResetReading();
  return out;
}

std::string document(const std::string& renderer) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n<qgis version=\"3.22.0\" styleCategories=\"Symbology\">" + renderer + "</qgis>\n";
}

}  // namespace

std::string layer_qml(LayerKind kind, OGRLayer& layer) {
  switch (kind) {
    case LayerKind::trees: return document(categorised("fate", fates()));
    case LayerKind::observations: return document(categorised("inventory", inventories_in(layer)));
    case LayerKind::links:
      return document(single(symbol("0", "line", "SimpleLine", {{"line_color", rgba(palette::accent, 200)}, {"line_style", "solid"}, {"line_width", "0.3"}, {"line_width_unit", "MM"}})));
    case LayerKind::coverage:
      return document(single(symbol("0", "fill", "SimpleFill", {{"color", rgba(palette::accent, 0)}, {"style", "no"}, {"outline_color", rgba(palette::secondary, 255)},
                                                                {"outline_style", "dash"}, {"outline_width", "0.3"}, {"outline_width_unit", "MM"}})));
    case LayerKind::matches:
    case LayerKind::inventories:
    case LayerKind::forestgeo: break;
  }
  return "";
}

}  // namespace stemwise
