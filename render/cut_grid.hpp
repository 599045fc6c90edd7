#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace stemwise::render {

/// A corner of a piece of a grid: a node (`from` equals `to`), or the place `share` of the way from one node to its neighbour.
struct CutCorner {
  std::size_t from = 0, to = 0;
  double share = 0.0;
  bool is_node() const { return from == to; }
};

/// What is left of a grid's cells where `inside` (at the nodes, row by row) is at least 0: whole cells, and parts of those
/// that the edge crosses, so that a surface ends in a smooth line and not in stairs. Corners turn counter-clockwise.
std::vector<std::vector<CutCorner>> cut_cells(int columns, int rows, std::span<const float> inside);

/// The part of one grid line between two neighbouring nodes that lies inside; nothing of it: both shares are 0.
std::array<double, 2> inner_shares(float inside_a, float inside_b);

}  // namespace stemwise::render
