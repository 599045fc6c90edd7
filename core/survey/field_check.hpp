#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/survey/tables.hpp"

namespace stemwise {

/// What azimuths on the ground count from, and what the frame's +y axis points to from there, clockwise.
struct NorthWords {
  std::string name;             ///< "true north", "grid north", "the reference's +y axis"
  double y_axis_azimuth_deg = 0.0;
};
NorthWords north_of(const Georeference& georeference);

/// How to reach a doubtful tree from a sure one.
struct FieldBearing {
  TreeId from;
  double distance_m = 0.0;      ///< horizontal, between the stems' centres
  double azimuth_deg = 0.0;     ///< standing at the sure tree, clockwise from FieldCheck::north
  std::optional<double> dbh_m;  ///< of the sure tree
};

struct FieldCheckRow {
  TreeId tree;
  std::string why;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the reference's frame
  bool has_z = false;
  std::optional<double> dbh_m;
  std::string species;
  std::vector<FieldBearing> bearings;  ///< nearest first, at most three
};

/// What to look at outside (product.md, item 11).
struct FieldCheck {
  std::string north;            ///< what azimuths count from: "true north", "grid north", "the reference's +y axis"
  std::vector<FieldCheckRow> rows;  ///< most doubtful first
};

/// The undecided trees of the review queue, each once, at most `most`. Sure trees: seen by the last survey and one before it,
/// of a confidence of at least 0.9, survivors without a flag or a place in the queue.
FieldCheck make_field_check(const ProjectState& state, const Tables& tables, std::size_t most = 100);

}  // namespace stemwise
