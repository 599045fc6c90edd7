#include "app/window/chart_host.hpp"

#include <algorithm>

namespace stemwise {
namespace {

ChartModel model_of(ui::Chart chart, const ProjectState& state, const Tables& tables, TreeId tree, std::size_t step) {
  if (chart == ui::Chart::tree_history) return dbh_over_time_chart(state, tables, tree);
  if (chart == ui::Chart::dbh_classes) return dbh_class_chart(state, tables);
  if (tables.growth.empty()) return {};
  const GrowthRow& growth = tables.growth[std::min(step, tables.growth.size() - 1)];
  const InventoryId from = growth.from, to = growth.to;
  if (chart == ui::Chart::growth_distribution) return growth_distribution_chart(state, tables, from, to);
  if (chart == ui::Chart::growth_against_dbh) return growth_against_dbh_chart(state, tables, from, to);
  if (chart == ui::Chart::residual_rose) return residual_rose_chart(state, tables, from, to);
  return residual_chart(state, tables, from, to);
}

}  // namespace

std::vector<TreeId> ChartHost::show(const ui::request::ShowChart& ask, const Document& document, const ui::ViewState& view, double scale) {
  const auto index = static_cast<std::size_t>(ask.chart);
  if (ask.width_px < 40 || ask.height_px < 40) return {};
  Key key;
  key.revision = document.derived().revision;
  key.style.size = {ask.width_px, ask.height_px};
  key.style.scale = scale;
  key.style.theme = view.theme == ui::ThemeName::dark ? render::Theme::dark : render::Theme::light;
  key.style.is_transparent = true;
  key.style.has_title = ask.chart != ui::Chart::tree_history;
  if (ask.chart == ui::Chart::tree_history) {
    key.tree = view.selected_tree;
  } else {
    key.step = view.growth_step;
    key.style.selected = view.group;
    if (view.selected_tree) key.style.selected.push_back(view.selected_tree);
  }
  const bool is_fitting = document.is_derived() || document.derived().tables.inventories.empty();  // of this very state
  if (is_fitting && !(painted_[index].key == key)) paint(ask.chart, key, document);
  if (ask.from_x_px >= 0.0) return render::trees_in_chart(painted_[index].model, painted_[index].layout, {ask.from_x_px, ask.from_y_px}, {ask.x_px, ask.y_px});
  const auto hit = ask.x_px < 0.0 ? std::nullopt : render::hit_chart(painted_[index].model, painted_[index].layout, {ask.x_px, ask.y_px}, 6.0 * scale);
  views_[index].tip = hit ? hit->text : "";
  return hit && ask.clicked ? hit->trees : std::vector<TreeId>{};
}

void ChartHost::paint(ui::Chart chart, const Key& key, const Document& document) {
  Painted& painted = painted_[static_cast<std::size_t>(chart)];
  if (painted.key.revision != key.revision || painted.key.tree != key.tree || painted.key.step != key.step) {
    painted.model = model_of(chart, document.state(), document.derived().tables, key.tree, key.step);
  }
  painted.key = key;
  const render::ChartPicture picture = render::paint_chart(painted.model, key.style);
  painted.layout = picture.layout;
  GlTexture& texture = textures_[static_cast<std::size_t>(chart)];
  texture.upload(picture.image.rgba.data(), picture.image.size.width, picture.image.size.height);
  ui::ChartView& view = views_[static_cast<std::size_t>(chart)];
  view.texture = texture.id();
  view.width_px = texture.width_px();
  view.height_px = texture.height_px();
  ++pictures_painted_;
  news_ = true;
}

Result<Done> ChartHost::write(ui::Chart chart, const std::string& path) const {
  render::ChartStyle style;
  style.scale = path.ends_with(".svg") ? 1.0 : 2.0;
  style.size = {static_cast<int>(720 * style.scale), static_cast<int>(440 * style.scale)};
  return render::write_chart(painted_[static_cast<std::size_t>(chart)].model, style, path);
}

}  // namespace stemwise
