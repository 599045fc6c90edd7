#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace stemwise {

/// One possible partnership; what it gains over leaving both alone.
struct AssignmentEdge {
  std::size_t left = 0;
  std::size_t right = 0;
  double gain = 0.0;
};

/// The one-to-one choice of edges whose gains sum to the most; anybody may stay alone. Exact: shortest augmenting paths with
/// potentials (Jonker and Volgenant 1987) over the edges there are, so connected components never see each other. Returns the
/// chosen edges' indices by left. Edges that gain nothing are never chosen; ties are broken the same way every time.
std::vector<std::size_t> assign_sparse(std::size_t lefts, std::size_t rights, std::span<const AssignmentEdge> edges);

}  // namespace stemwise
