#pragma once
#include <set>
#include <string>

#include "core/base/issue.hpp"
#include "io/gdal_dataset.hpp"

namespace stemwise {

// Only for .cpp files of io: names GDAL.

/// Copies what a person put into a project file beside Stemwise's own layers and tables: whole layers (with their ids, keys
/// and geometry), QGIS's styles and its project table. A warning for every one that cannot be copied.
Issues keep_foreign_layers(const std::string& old_path, GDALDataset& into);

/// QGIS's table of styles: one style per map layer that has one, and the styles that a person saved in the old file (which
/// stay the default where they were).
Issues write_layer_styles(const std::string& old_path, GDALDataset& into);

}  // namespace stemwise
