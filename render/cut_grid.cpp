#include "render/cut_grid.hpp"

namespace stemwise::render {
namespace {

double crossing(float a, float b) { return static_cast<double>(a) / (static_cast<double>(a) - static_cast<double>(b)); }

std::vector<CutCorner> cut_cell(const std::array<std::size_t, 4>& nodes, std::span<const float> inside) {
  std::vector<CutCorner> piece;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t here = nodes[i], next = nodes[(i + 1) % nodes.size()];
    const bool is_in = inside[here] >= 0.0F;
    if (is_in) piece.push_back({here, here, 0.0});
    if (is_in != (inside[next] >= 0.0F)) piece.push_back({here, next, crossing(inside[here], inside[next])});
  }
  return piece;
}

}  // namespace

std::vector<std::vector<CutCorner>> cut_cells(int columns, int rows, std::span<const float> inside) {
  std::vector<std::vector<CutCorner>> pieces;
  const auto at = [columns](int column, int row) { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column); };
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      auto piece = cut_cell({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)}, inside);
      if (piece.size() >= 3) pieces.push_back(std::move(piece));
    }
  return pieces;
}

std::array<double, 2> inner_shares(float inside_a, float inside_b) {
  const bool a = inside_a >= 0.0F, b = inside_b >= 0.0F;
  if (!a && !b) return {0.0, 0.0};
  if (a && b) return {0.0, 1.0};
  const double cut = crossing(inside_a, inside_b);
  return a ? std::array{0.0, cut} : std::array{cut, 1.0};
}

}  // namespace stemwise::render
