#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/issue.hpp"
#include "core/geodesy/georeference.hpp"
#include "core/survey/policy_effect.hpp"
#include "core/survey/rule_pack.hpp"

namespace stemwise::ui {

// What the forms of steps 4 and 5 say (kept in the view state), and what would come of it: worked out beside the window
// whenever the project or the form changed, and shown before anything is applied.

enum class PlaceWay { anchor, control, gnss, crs };

/// A tree whose place on the earth was typed in.
struct TypedControl {
  TreeId tree;
  double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0;
  bool has_height = false;
  bool operator==(const TypedControl&) const = default;
};

struct PlacementForm {
  PlaceWay way = PlaceWay::anchor;
  double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0, azimuth_deg = 0.0;
  int azimuth_kind = 0;            ///< true, grid, magnetic north
  double declination_deg = 0.0;    ///< of the magnetic one; 0: by the model of the earth's field
  std::string control_file, gnss_file;
  std::vector<TypedControl> typed;
  bool translation_only = false;   ///< control points: keep `azimuth_deg`
  int level = 0;                   ///< automatic, level, leaning
  double outlier_m = 3.0;
  std::string geoid;
  int epsg = 0;
  InventoryId inventory;           ///< whose coordinates or trajectory; none: the reference
  double sd_m = 0.0;
  double time_offset_s = 0.0;
  bool operator==(const PlacementForm&) const = default;
};

struct PlacementPreview {
  PlacementForm form;
  std::uint64_t revision = 0;
  bool usable = false;
  Georeference georeference;
  std::vector<Eigen::Vector3d> places_m;  ///< of the control points in the reference's frame, in the order of the residuals
  std::vector<std::string> said;   ///< the fit's quality
  std::string where;               ///< where the middle of the stems comes to lie, in words
  Issues issues;
};

struct FusionPreview {
  std::uint64_t revision = 0;
  std::array<PolicyEffect, 4> policies{};  ///< in the order of FusionPolicy
};

/// What the rules of one pack would flag.
struct RulePreview {
  RulePack pack;
  std::vector<RuleCount> counts;
};
struct RulePreviews {
  std::uint64_t revision = 0;
  std::vector<RulePreview> packs;  ///< the built-in ones, then a person's own
};

struct ExportForm {
  std::string layer = "trees";
  int epsg = 0;                    ///< 0: the project's own
  bool operator==(const ExportForm&) const = default;
};
struct ExportPreview {
  ExportForm form;
  std::uint64_t revision = 0;
  std::int64_t rows = 0;
  std::string system;              ///< "WGS 84 / UTM zone 32N", "local coordinates"
  std::vector<std::pair<std::string, std::string>> first;  ///< the first row: column and value
  Issues issues;                   ///< why it cannot be written so
};

struct ReportPreview {
  std::uint64_t revision = 0;
  double area_ha = 0.0;
  std::vector<std::array<std::string, 3>> figures;            ///< of the cover: label, value, detail
  std::vector<std::pair<std::string, std::string>> sections;  ///< title, and what is in it
  int field_check_trees = 0;
};

enum class PrintedSheet { report, field_check };
/// The page of the report or the field check sheet that is looked at, and how large.
struct PageForm {
  PrintedSheet sheet = PrintedSheet::report;
  int page = 0;
  int width_px = 0;                ///< 0: not shown yet
  double area_ha = 0.0;
  int most_trees = 0;
  bool operator==(const PageForm&) const = default;
};
struct PageView {
  PageForm form;
  std::uint64_t revision = 0;
  int pages = 0;
  std::uint64_t texture = 0;       ///< first row on top
  int width_px = 0, height_px = 0;
};

}  // namespace stemwise::ui
