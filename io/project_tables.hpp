#pragma once
#include <array>

#include "io/gdal_table.hpp"

namespace stemwise::project_tables {

// The schema of a project file's own tables, shared by writer and reader. Units in the names. Version 1.

inline constexpr int format_version = 1;
inline constexpr const char* fingerprint_key = "fingerprint";  ///< in `project`: of everything else in these tables

inline constexpr std::array project = {TableField{"key", OFTString}, TableField{"value", OFTString}};
inline constexpr std::array settings = {TableField{"key", OFTString}, TableField{"value", OFTString}};
inline constexpr std::array inventories = {TableField{"inventory_id", OFTInteger64}, TableField{"name", OFTString}, TableField{"date_days", OFTInteger64},
                                           TableField{"date", OFTString}, TableField{"path", OFTString}, TableField{"format", OFTString},
                                           TableField{"epsg", OFTInteger64}, TableField{"notes", OFTString}, TableField{"has_trees", OFTInteger64}};
inline constexpr std::array stems = {TableField{"inventory_id", OFTInteger64}, TableField{"stem_index", OFTInteger64}, TableField{"source_id", OFTString},
                                     TableField{"source_row", OFTInteger64}, TableField{"x_m", OFTReal}, TableField{"y_m", OFTReal},
                                     TableField{"z_m", OFTReal}, TableField{"dbh_m", OFTReal}, TableField{"dbh_approximation_m", OFTReal},
                                     TableField{"axis_x", OFTReal}, TableField{"axis_y", OFTReal}, TableField{"axis_z", OFTReal},
                                     TableField{"height_m", OFTReal}, TableField{"reconstructed", OFTInteger64}, TableField{"score", OFTReal},
                                     TableField{"number_clusters", OFTInteger64}, TableField{"times_seen", OFTInteger64}, TableField{"status", OFTString},
                                     TableField{"date_days", OFTInteger64}, TableField{"species", OFTString}, TableField{"note", OFTString},
                                     TableField{"tree_id", OFTInteger64}};
inline constexpr std::array alignments = {TableField{"inventory_id", OFTInteger64}, TableField{"status", OFTString}, TableField{"reason", OFTString},
                                          TableField{"reference_from_inventory", OFTString}, TableField{"observed", OFTString},
                                          TableField{"overlap", OFTReal}, TableField{"position_noise_m", OFTReal},
                                          TableField{"log_likelihood_ratio", OFTReal}, TableField{"log_poses_tried", OFTReal}, TableField{"margin", OFTReal},
                                          TableField{"second_best", OFTReal}, TableField{"mirror", OFTReal}, TableField{"probability", OFTReal},
                                          TableField{"matched", OFTInteger64}, TableField{"residual_rms_m", OFTReal},
                                          TableField{"second_best_pose", OFTString}};
inline constexpr std::array coverages = {TableField{"inventory_id", OFTInteger64}, TableField{"source", OFTString}, TableField{"corners_m", OFTString}};
inline constexpr std::array dbh_errors = {TableField{"inventory_id", OFTInteger64}, TableField{"dbh_error_m", OFTReal}};
inline constexpr std::array pairs = {TableField{"inventory_a", OFTInteger64}, TableField{"inventory_b", OFTInteger64}, TableField{"constraints", OFTInteger64},
                                     TableField{"accepted", OFTInteger64}};
inline constexpr std::array matches = {TableField{"inventory_a", OFTInteger64}, TableField{"stem_a", OFTInteger64}, TableField{"inventory_b", OFTInteger64},
                                       TableField{"stem_b", OFTInteger64}, TableField{"distance_m", OFTReal}, TableField{"confidence", OFTReal},
                                       TableField{"state", OFTString}, TableField{"second_inventory", OFTInteger64}, TableField{"second_stem", OFTInteger64},
                                       TableField{"second_distance_m", OFTReal}, TableField{"flipped", OFTInteger64}};
inline constexpr std::array trees = {TableField{"tree_id", OFTInteger64}, TableField{"stems", OFTString}, TableField{"fate_by_hand", OFTString},
                                     TableField{"note", OFTString}, TableField{"edited_by", OFTString}};
inline constexpr std::array edit_log = {TableField{"entry", OFTInteger64}, TableField{"time_utc", OFTString}, TableField{"author", OFTString},
                                        TableField{"what", OFTString}, TableField{"before", OFTString}, TableField{"after", OFTString},
                                        TableField{"note", OFTString}};

}  // namespace stemwise::project_tables
