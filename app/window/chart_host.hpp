#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "app/window/document.hpp"
#include "app/window/gl_texture.hpp"
#include "render/chart_painter.hpp"
#include "ui/charts.hpp"
#include "ui/requests.hpp"
#include "ui/view_state.hpp"

namespace stemwise {

/// Paints the charts that panels ask for into textures; paints again only when data, size, theme or selection changed.
class ChartHost {
 public:
  /// Needs the GL context. The trees that a click or a rectangle stands for, none without.
  std::vector<TreeId> show(const ui::request::ShowChart& ask, const Document& document, const ui::ViewState& view, double scale);
  /// The chart as it is shown now, on white: .png or .svg.
  Result<Done> write(ui::Chart chart, const std::string& path) const;
  const ui::ChartViews& views() const { return views_; }
  /// True once after something was painted: the window has to be drawn again to show it.
  std::uint64_t pictures_painted() const { return pictures_painted_; }
  bool take_news() { return std::exchange(news_, false); }

 private:
  struct Key {
    std::uint64_t revision = ~0ULL;
    TreeId tree;
    std::size_t step = 0;
    render::ChartStyle style;
    bool operator==(const Key&) const = default;
  };
  struct Painted {
    Key key;
    ChartModel model;
    render::ChartLayout layout;
  };
  void paint(ui::Chart chart, const Key& key, const Document& document);

  std::array<Painted, ui::chart_count> painted_;
  std::array<GlTexture, ui::chart_count> textures_;
  ui::ChartViews views_;
  std::uint64_t pictures_painted_ = 0;
  bool news_ = false;
};

}  // namespace stemwise
