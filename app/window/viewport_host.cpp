#include "app/window/viewport_host.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/click_effect.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "core/survey/field_check.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

constexpr double blink_period_s = 0.7;

render::ColorBy color_by(ui::ColorBy by) { return static_cast<render::ColorBy>(by); }
static_assert(static_cast<int>(render::HeatMap::residual) == static_cast<int>(ui::Heat::residual));
static_assert(static_cast<int>(render::ColorBy::times_seen) == static_cast<int>(ui::ColorBy::times_seen) &&
              static_cast<int>(render::ColorBy::growth) == static_cast<int>(ui::ColorBy::growth));

std::vector<InventoryId> hidden_now(const Document& document, const ui::ViewState& view, double now_s) {
  std::vector<InventoryId> hidden(view.hidden.begin(), view.hidden.end());
  const std::vector<InventoryId>& placed = document.derived().tables.inventories;
  if (!view.blink || placed.size() < 2) return hidden;
  const bool first = std::fmod(now_s, 2.0 * blink_period_s) < blink_period_s;
  hidden.assign(placed.begin(), placed.end());
  std::erase(hidden, first ? placed.front() : placed.back());
  return hidden;
}

/// First to last DBH; of a match in doubt the two that it is about.
std::string dbh_span(const TreeRow& tree, const MatchRow* doubted) {
  if (doubted != nullptr && doubted->dbh_a_m && doubted->dbh_b_m) return ui::dbh_text(doubted->dbh_a_m) + " to " + ui::dbh_text(doubted->dbh_b_m) + " cm";
  std::optional<double> first, last;
  for (const auto& dbh : tree.dbh_per_inventory_m) {
    if (!dbh) continue;
    if (!first) first = dbh;
    last = dbh;
  }
  if (!first) return "no DBH";
  if (tree.times_seen < 2 || first == last) return ui::dbh_text(last) + " cm";
  return ui::dbh_text(first) + " to " + ui::dbh_text(last) + " cm";
}

Eigen::Vector2d middle_of(const Inventory& inventory) {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  for (const Stem& stem : inventory.stems) middle_m += Eigen::Vector2d(stem.x_m, stem.y_m) / static_cast<double>(inventory.stems.size());
  return middle_m;
}

/// A survey as it was given: its own axes, moved only so far that its middle lies on that of the reference.
render::Ghost as_given(const Inventory& inventory, const Inventory& reference) {
  const Eigen::Vector2d shift_m = middle_of(reference) - middle_of(inventory);
  return {inventory.id, RigidTransform::planar(shift_m.x(), shift_m.y(), 0.0)};
}

/// The second-best pose of the survey that is looked at.
std::optional<render::Ghost> second_best(const ProjectState& state, const ui::ViewState& view) {
  const auto alignment = state.alignments.find(ui::survey_to_compare(state, view));
  if (!view.ghost || alignment == state.alignments.end()) return std::nullopt;
  if (alignment->second.status == AlignmentStatus::probable && !state.is_placed(alignment->first)) return render::Ghost{alignment->first, alignment->second.reference_from_inventory};
  if (!alignment->second.second_best_pose) return std::nullopt;
  return render::Ghost{alignment->first, *alignment->second.second_best_pose};
}

/// Mirrors the project once its tables are there: tables of an earlier revision name stems and poses that may be gone by now.
void sync(render::Viewport& viewport, const Document& document) {
  const ui::Derived& derived = document.derived();
  if (document.is_derived() || derived.tables.inventories.empty()) viewport.sync(document.state(), derived.tables, derived.revision);
}

}  // namespace

/// Two pictures side by side: what is hidden in each, and what they are called.
struct ViewportHost::Comparison {
  std::vector<InventoryId> hidden_left, hidden_right;
  std::optional<render::Ghost> ghost_left;
  std::string left, right;
  bool by_inventory = false;  ///< the colours that tell most
};

std::optional<ViewportHost::Comparison> ViewportHost::comparison_of(const Document& document, const ui::ViewState& view) {
  const ProjectState& state = document.state();
  const std::vector<InventoryId>& placed = document.derived().tables.inventories;
  if (placed.size() < 2 || !(view.slide || view.before_after)) return std::nullopt;
  Comparison c{placed, placed, {}, {}, {}, false};
  if (view.slide) {
    std::erase(c.hidden_left, placed[placed.size() - 2]);
    std::erase(c.hidden_right, placed.back());
    c.left = ui::survey_label(state, placed[placed.size() - 2]);
    c.right = ui::survey_label(state, placed.back());
    return c;
  }
  const InventoryId id = ui::survey_to_compare(state, view);
  const Inventory *inventory = state.find(id), *reference = state.find(state.reference);
  if (inventory == nullptr || reference == nullptr || id == state.reference || !state.is_placed(id)) return std::nullopt;
  std::erase(c.hidden_left, state.reference);
  c.hidden_right = c.hidden_left;
  std::erase(c.hidden_right, id);
  c.ghost_left = as_given(*inventory, *reference);
  c.left = ui::survey_label(state, id) + " as it was given";
  c.right = "aligned";
  c.by_inventory = true;
  return c;
}

void ViewportHost::update(const Document& document, const ui::ViewState& view, std::vector<render::ShownUnderlay> underlays, double now_s) {
  render::ViewOptions options;
  options.kind = view.mode == ui::ViewMode::map ? render::ViewKind::map : render::ViewKind::space;
  options.color_by = color_by(view.color_by);
  options.theme = view.theme == ui::ThemeName::dark ? render::Theme::dark : render::Theme::light;
  options.hidden = hidden_now(document, view, now_s);
  options.links = view.layers.links;
  options.coverage = view.layers.coverage;
  options.grid = view.layers.grid;
  options.ground = view.layers.ground;
  options.labels = view.layers.labels;
  options.legend = view.color_by != ui::ColorBy::fate || !view.panels.show_left;
  options.residuals = view.layers.residuals;
  options.heat = static_cast<render::HeatMap>(view.heat);
  options.selected = view.group;
  if (view.selected_tree) options.selected.push_back(view.selected_tree);
  if (!view.selected_tree && view.selected_stem.index >= 0) options.selected_stems = {view.selected_stem};
  options.hovered = hovered_;
  options.moving = dragging_;
  options.underlays = std::move(underlays);
  options.ghost = second_best(document.state(), view);
  if (view.tool == ui::Tool::pair) {
    for (const auto& [known, other] : view.pairs) options.selected_stems.insert(options.selected_stems.end(), {known, other});
    if (view.link_from.index >= 0) options.selected_stems.push_back(view.link_from);
  }
  if (view.tool != ui::Tool::lasso && view.tool != ui::Tool::coverage) shape_.forget();
  const std::optional<Comparison> comparison = comparison_of(document, view);
  if (comparison) {
    options.hidden = comparison->hidden_left;
    options.ghost = comparison->ghost_left;
    if (comparison->by_inventory) options.color_by = render::ColorBy::inventory;
  }
  viewport_.set_options(options);
  sync(viewport_, document);
  update_later(document, options, comparison);
}

void ViewportHost::update_later(const Document& document, render::ViewOptions options, const std::optional<Comparison>& comparison) {
  if (!comparison) {
    later_.reset();
    return;
  }
  options.hidden = comparison->hidden_right;
  options.ghost.reset();
  earlier_name_ = comparison->left;
  later_name_ = comparison->right;
  if (!later_) later_.emplace();
  later_->set_options(options);
  sync(*later_, document);
}

ui::ViewportPicture ViewportHost::render(const ui::Rect& rect, double scale) {
  const render::PixelSize size{static_cast<int>(std::lround(rect.width)), static_cast<int>(std::lround(rect.height))};
  live_.clear();
  if (size.width < 8 || size.height < 8) return {};
  shown_ = {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  const std::uint32_t texture = viewport_.render(size, scale);
  if (renderer_.empty()) renderer_ = viewport_.renderer_name();
  live_.push_back({texture, viewport_.pictures_drawn(), size.width, size.height, true});
  if (!later_) return {texture, size.width, size.height};
  later_->resize(size, scale);
  later_->follow(viewport_);
  const std::uint32_t later = later_->render(size, scale);
  live_.push_back({later, later_->pictures_drawn(), size.width, size.height, true});
  return {texture, size.width, size.height, later, earlier_name_, later_name_};
}

bool ViewportHost::advance(double elapsed_s, const ui::ViewState& view) {
  const bool flying = viewport_.advance(elapsed_s);
  return flying || view.blink || dragging_;
}

void ViewportHost::move_camera(const ui::request::Pointer& p, bool space) {
  if (space && p.left_down && !p.shift) {
    viewport_.orbit(p.dx_px, p.dy_px);
  } else {
    viewport_.pan(p.dx_px, p.dy_px);
  }
}

void ViewportHost::draw_box(const ui::request::Pointer& p) {
  const auto x = static_cast<float>(p.x_px), y = static_cast<float>(p.y_px);
  if (!box_) box_ = ui::Rect{x - static_cast<float>(p.dx_px), y - static_cast<float>(p.dy_px), 0, 0};
  box_->width = x - box_->x;
  box_->height = y - box_->y;
}

std::optional<ui::MapRegion> ViewportHost::map_region() const {
  const auto a = viewport_.world_at(0, 0), b = viewport_.world_at(shown_.width, shown_.height);
  const auto c = viewport_.world_at(shown_.width, 0), d = viewport_.world_at(0, shown_.height);
  if (shown_.width < 8 || !a || !b || !c || !d) return std::nullopt;
  ui::MapRegion region{1e300, 1e300, -1e300, -1e300};
  for (const auto& corner : {a, b, c, d}) {
    region.low_x_m = std::min(region.low_x_m, corner->position_m.x());
    region.low_y_m = std::min(region.low_y_m, corner->position_m.y());
    region.high_x_m = std::max(region.high_x_m, corner->position_m.x());
    region.high_y_m = std::max(region.high_y_m, corner->position_m.y());
  }
  return region;
}

const render::Viewport& ViewportHost::picture_at(double x_px, const ui::ViewState& view) const {
  return later_ && x_px > static_cast<double>(view.slide_at * shown_.width) ? *later_ : viewport_;
}

std::optional<render::Pick> ViewportHost::pointer(const ui::request::Pointer& p, const ui::ViewState& view) {
  const bool space = view.mode == ui::ViewMode::space;
  const bool moves = p.left_down || p.middle_down || p.right_down;
  const bool boxes = p.left_down && (box_ || view.tool == ui::Tool::rectangle || (p.shift && !space));
  dragging_ = moves && !boxes && (p.dx_px != 0.0 || p.dy_px != 0.0 || dragging_);
  if (boxes) {
    draw_box(p);
  } else if (moves) {
    move_camera(p, space);
  }
  if (box_ && !p.left_down) {
    drawn_selection_ = viewport_.trees_in_rectangle(box_->x, box_->y, box_->x + box_->width, box_->y + box_->height);
    box_.reset();
  }
  if (p.wheel != 0.0) viewport_.zoom_at(p.x_px, p.y_px, std::pow(1.2, p.wheel));
  cursor_px_ = p.hovered ? std::optional<Eigen::Vector2d>({p.x_px, p.y_px}) : std::nullopt;
  const std::optional<render::Pick> under = p.hovered && !moves ? picture_at(p.x_px, view).pick(p.x_px, p.y_px) : std::nullopt;
  hovered_ = under ? under->tree : TreeId{};
  hovered_stem_ = under ? under->stem : StemRef{};
  if (!p.clicked) return std::nullopt;
  if (view.tool == ui::Tool::lasso || view.tool == ui::Tool::coverage) {
    shape_.click(viewport_, p.x_px, p.y_px);
    return std::nullopt;
  }
  if (view.tool != ui::Tool::measure) return under;
  if (const auto world = viewport_.world_at(p.x_px, p.y_px)) {
    if (measured_.size() >= 2) measured_.clear();
    measured_.push_back(world->position_m);
  }
  return std::nullopt;
}

void ViewportHost::describe(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const {
  describe_hover(document, view, status);
  describe_click(document, view, status);
  describe_cursor(document, status);
  describe_measure(document, view, status);
  describe_shapes(document, view, status);
  status.renderer = renderer_;
}

void ViewportHost::describe_hover(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const {
  status.hover.reset();
  const TreeId shown = hovered_ ? hovered_ : view.selected_tree;
  const TreeRow* tree = document.derived().tree(shown);
  const auto at = tree != nullptr ? viewport_.pixels_of(shown) : std::nullopt;
  if (!at && !hovered_ && hovered_stem_.index >= 0) {  // of a survey that is not aligned
    const auto stem_at = viewport_.pixels_of(hovered_stem_);
    const Stem* stem = document.state().find(hovered_stem_);
    if (!stem_at || stem == nullptr) return;
    const std::string dbh = stem->dbh_m ? ui::dbh_text(stem->dbh_m) + " cm" : "no DBH";
    status.hover = ui::HoverCard{stem_at->x(), stem_at->y(), ui::stem_label(document.state(), hovered_stem_) + " · " + dbh, "not aligned", false};
  }
  if (!at) return;
  const QueueRow* doubt = document.derived().doubt(shown);
  const bool open = doubt != nullptr && !doubt->decided;
  const MatchRow* doubted = open && doubt->match ? &document.derived().tables.matches[*doubt->match] : nullptr;
  ui::HoverCard card{at->x(), at->y(), tree_label(shown) + " · " + dbh_span(*tree, doubted), fate_label(tree->fate), false};
  if (open) {
    card.detail = doubt->why;
    card.warning = true;
  }
  status.hover = std::move(card);
}

void ViewportHost::describe_click(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const {
  status.click_line.reset();
  status.selection_box.reset();
  if (box_) status.selection_box = ui::Rect{std::min(box_->x, box_->x + box_->width), std::min(box_->y, box_->y + box_->height), std::abs(box_->width), std::abs(box_->height)};
  const bool pairs = view.tool == ui::Tool::link || view.tool == ui::Tool::swap || view.tool == ui::Tool::merge;
  if (!pairs || !hovered_stem_.inventory || !hovered_) return;
  const ClickEffect effect = effect_of_click(document.state(), view.tool, view.link_from, hovered_stem_);
  const auto a = viewport_.pixels_of(document.state().tree_of(view.link_from)), b = viewport_.pixels_of(hovered_);
  if (a && b) status.click_line = ui::OverlayLine{a->x(), a->y(), b->x(), b->y()};
  if (!status.hover) return;
  status.hover->detail = effect.words;
  status.hover->warning = !effect.possible;
}

void ViewportHost::describe_cursor(const Document& document, ui::WindowStatus& status) const {
  status.cursor_local.clear();
  status.cursor_projected.clear();
  status.cursor_geographic.clear();
  const auto world = cursor_px_ ? viewport_.world_at(cursor_px_->x(), cursor_px_->y()) : std::nullopt;
  if (!world) return;
  const Eigen::Vector3d& p = world->position_m;
  status.cursor_local = "x " + ui::grouped(p.x(), 2) + " m   y " + ui::grouped(p.y(), 2) + " m";
  const Georeference& g = document.state().georeference;
  if (g.kind == GeoreferenceKind::crs) {
    status.cursor_projected = "EPSG:" + std::to_string(g.epsg) + "   " + ui::grouped(p.x(), 1) + " E   " + ui::grouped(p.y(), 1) + " N";
  }
  if (g.kind != GeoreferenceKind::anchor) return;
  const Geodetic earth = geodetic_from_reference(g, p);
  if (const auto utm = utm_from_geodetic(earth, g.origin)) {
    status.cursor_projected = "UTM " + std::to_string(utm->zone) + (utm->north ? "N" : "S") + "   " + ui::grouped(utm->easting_m, 1) + " E   " +
                              ui::grouped(utm->northing_m, 1) + " N";
  }
  status.cursor_geographic = ui::fixed(std::abs(earth.latitude_deg), 5) + (earth.latitude_deg < 0 ? "° S   " : "° N   ") +
                             ui::fixed(std::abs(earth.longitude_deg), 5) + (earth.longitude_deg < 0 ? "° W" : "° E");
}

void ViewportHost::describe_shapes(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const {
  status.shape = shape_.sides(viewport_, cursor_px_);
  status.pair_lines.clear();
  status.control_marks.clear();
  const bool places = view.step == ui::Step::merge && status.placement && status.placement->form == view.placement;
  for (std::size_t i = 0; places && i < status.placement->places_m.size(); ++i) {
    const ControlResidual& residual = status.placement->georeference.residuals[i];
    const Eigen::Vector2d at = viewport_.pixels_of(status.placement->places_m[i]);
    status.control_marks.push_back({at.x(), at.y(), residual.name + ": " + ui::distance_text(residual.residual_m), !residual.used});
  }
  if (view.tool != ui::Tool::pair) return;
  const auto place = [&](StemRef stem) {
    const auto at = viewport_.pixels_of(stem);
    return at ? at : viewport_.pixels_of(document.state().tree_of(stem));
  };
  for (const auto& [known, other] : view.pairs) {
    const auto a = place(known), b = place(other);
    if (a && b) status.pair_lines.push_back({a->x(), a->y(), b->x(), b->y()});
  }
  const auto from = view.link_from.index >= 0 ? place(view.link_from) : std::nullopt;
  if (from && cursor_px_) status.pair_lines.push_back({from->x(), from->y(), cursor_px_->x(), cursor_px_->y()});
}

void ViewportHost::describe_measure(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const {
  status.measure_text.clear();
  status.measure_line.reset();
  if (view.tool != ui::Tool::measure) return;
  status.measure_text = "Click two points to measure.  Esc: stop";
  if (measured_.empty()) return;
  const Eigen::Vector3d& from = measured_.front();
  Eigen::Vector3d to = from;
  if (measured_.size() == 2) {
    to = measured_.back();
  } else if (cursor_px_) {
    if (const auto world = viewport_.world_at(cursor_px_->x(), cursor_px_->y())) to = world->position_m;
  }
  const Eigen::Vector2d a = viewport_.pixels_of(from), b = viewport_.pixels_of(to);
  status.measure_line = ui::OverlayLine{a.x(), a.y(), b.x(), b.y()};
  const Eigen::Vector3d way = to - from;
  const NorthWords north = north_of(document.state().georeference);
  const double azimuth_deg = std::fmod(degrees(std::atan2(way.x(), way.y())) + north.y_axis_azimuth_deg + 720.0, 360.0);
  status.measure_text = ui::distance_text(way.head<2>().norm()) + " at " + ui::fixed(azimuth_deg, 1) + "° from " + north.name + ".  Esc: stop";
}

}  // namespace stemwise
