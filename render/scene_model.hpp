#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"
#include "render/color_by.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

// What is to be seen, as plain values: everything that draws, picks or labels reads this. Positions in metres relative to
// `SceneModel::origin_m`, so that floats on the graphics card keep millimetres at UTM scale.

/// One circle on the map, one stem in 3D: a sighting, or a whole tree at its newest shown sighting.
struct Mark {
  TreeId tree;
  StemRef stem;
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double dbh_m = 0.0;     ///< a small stand-in where unknown
  double height_m = 0.0;  ///< measured, or a guess for display
  int times_seen = 0;     ///< surveys; 0 for a stem in no tree
  std::optional<double> residual_m;
  MarkStyle style;
};

struct Link {
  TreeId tree;
  Eigen::Vector3d a_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d b_m = Eigen::Vector3d::Zero();
};

struct CoverageShape {
  InventoryId inventory;
  std::vector<Eigen::Vector2d> corners_m;
  Rgba outline;
};

/// A survey without a place in the reference's frame, shown beside it: position = own coordinates + offset. While there is
/// such a survey the reference has one too (for its caption), with an offset of minus the scene's origin.
struct SideFrame {
  InventoryId inventory;
  Eigen::Vector2d scene_from_own_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();  ///< of its box in the scene
  Eigen::Vector2d high_m = Eigen::Vector2d::Zero();
  std::string caption;  ///< "2023, not aligned yet"
  Rgba colour;
};

struct SceneModel {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  InventoryId reference;
  std::vector<Mark> marks;       ///< ghosts not included
  std::vector<Mark> ghosts;
  std::vector<Link> links;
  std::vector<CoverageShape> coverages;
  std::vector<SideFrame> side_frames;
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_m = Eigen::Vector3d::Zero();
  double residual_factor = 1.0;  ///< residual arrows are drawn this many times as long as they are
  double spacing_m = 4.0;        ///< typical distance between neighbouring trees
  std::optional<double> north_azimuth_rad;  ///< of the +y axis, clockwise from north; nothing while nobody has said where north is
  int surveys = 0;               ///< that have a place
  bool shows_sightings = false;  ///< a mark per sighting, several on one spot; else one per tree
  bool has_terrain = false;      ///< at least three marks have a measured base height
  Legend legend;
  Legend heat_legend;  ///< empty title: no heat map
  std::unordered_map<TreeId, Eigen::Vector3d> alternative_of_tree;  ///< where its newest match's second choice stands
  std::unordered_map<TreeId, std::size_t> mark_of_tree;  ///< its newest shown sighting
  std::unordered_map<StemRef, std::size_t> mark_of_stem;

  bool empty() const { return marks.empty(); }
  const Mark* find(TreeId tree) const;
  const Mark* find(StemRef stem) const;
};

SceneModel build_scene(const ProjectState& state, const Tables& tables, const ViewOptions& options);

/// A height for display only, from the diameter (a saturating curve); never leaves the picture.
double display_height_m(double dbh_m);

}  // namespace stemwise::render
