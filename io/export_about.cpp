#include "io/export_about.hpp"

#include <cstdio>

#include "io/crs.hpp"
#include "io/write_layers.hpp"

namespace stemwise {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::string alignment_text(const InventoryAlignment& a) {
  char text[160];
  std::snprintf(text, sizeof text, "%s, matched %d, residual RMS %.3f m, overlap %.3f", to_string(a.status), a.matched, a.residual_rms_m, a.overlap);
  return text;
}

Pairs about(const ProjectState& state, const EarthFrame& frame, const std::string& software) {
  Pairs pairs;
  const auto add = [&pairs](std::string key, std::string value) { pairs.emplace_back(std::move(key), std::move(value)); };
  add("software", software);
  add("project", state.title);
  add("coordinate_system", frame.epsg() ? crs_name(*frame.epsg()) + " (EPSG:" + std::to_string(*frame.epsg()) + ")" : "local, reference's frame, m");
  add("heights", "above " + (frame.epsg() ? frame.height_datum() : std::string("the reference's zero")));
  add("units", "lengths m, DBH cm, growth cm per year of 365.25 days, angles degrees");
  add("georeference", state.georeference.method);
  for (const ControlResidual& r : state.georeference.residuals) {
    char text[96];
    std::snprintf(text, sizeof text, "%.3f m%s", r.residual_m, r.used ? "" : ", left out");
    add("georeference residual of " + r.name, text);
  }
  add("fusion", to_string(state.fusion));
  if (const Inventory* reference = state.find(state.reference)) add("reference", reference->name);
  for (const auto& [id, a] : state.alignments) {
    const Inventory* inventory = state.find(id);
    if (inventory != nullptr && id != state.reference) add("alignment of " + inventory->name, alignment_text(a));
  }
  if (!state.settings.contains("seed")) add("seed", "0");
  for (const auto& [key, value] : state.settings) add(key == "seed" ? key : "setting " + key, value);
  return pairs;
}

}  // namespace

Layer about_layer(const ProjectState& state, const EarthFrame& frame, const std::string& software) {
  Layer layer;
  layer.name = "metadata";
  layer.title = "About this export";
  layer.columns = {{"key", ColumnType::text, 0, {}}, {"value", ColumnType::text, 0, {}}};
  for (auto& [key, value] : about(state, frame, software)) layer.features.push_back({{std::move(key), std::move(value)}, {}});
  return layer;
}

Layer data_dictionary(const std::vector<Layer>& layers) {
  Layer dictionary;
  dictionary.name = "data_dictionary";
  dictionary.title = "What every column means";
  dictionary.columns = {{"layer", ColumnType::text, 0, {}}, {"column", ColumnType::text, 0, {}}, {"meaning", ColumnType::text, 0, {}}};
  for (const Layer& layer : layers) {
    for (const LayerColumn& column : layer.columns) dictionary.features.push_back({{layer.name, column.name, column.description}, {}});
  }
  return dictionary;
}

std::string about_text(const ProjectState& state, const EarthFrame& frame, const std::string& software, const Layer& layer, bool short_names) {
  std::string text = layer.title + "\n\n";
  for (const auto& [key, value] : about(state, frame, software)) text += key + ": " + value + "\n";
  text += "\nColumns\n";
  const std::vector<std::string> names = short_names ? short_column_names(layer.columns) : std::vector<std::string>();
  for (std::size_t i = 0; i < layer.columns.size(); ++i)
    text += (short_names ? names[i] + " = " : "") + layer.columns[i].name + ": " + layer.columns[i].description + "\n";
  return text;
}

}  // namespace stemwise
