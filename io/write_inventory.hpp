#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"

namespace stemwise {

/// The shortest text that reads back as exactly this number; empty for nothing.
std::string exact_number(double value);

/// A stem table as Stemwise writes it (cli.md, "Tables written"): id, x_m, y_m, z_m, dbh_cm, axis_x, axis_y, axis_z, species,
/// status, date; what is unknown is empty. `delimiter` "\t" for TSV.
std::string stem_table(const Inventory& inventory, char delimiter = ',');

/// A frame folder (data-formats.md): trajectory.txt and TreeManagerState_<n>.csv, numbered from 0. The folder is put in place
/// whole; one that is there already and holds anything else than a frame folder is refused.
Result<Done> write_frame_folder(const std::string& folder, const FrameSet& frames);

/// What an inventory can be written as; "": a folder of frames.
const std::vector<std::string>& inventory_suffixes();

/// By name: .csv, .tsv, .txt, or no suffix for a frame folder (which needs frames). An issue for anything else.
Result<Done> write_inventory(const std::string& path, const Inventory& inventory);

}  // namespace stemwise
