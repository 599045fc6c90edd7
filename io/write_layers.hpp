#pragma once
#include <string>
#include <vector>

#include "core/base/issue.hpp"
#include "io/gdal_dataset.hpp"
#include "io/layer.hpp"

namespace stemwise {

// Only for .cpp files of io: names GDAL.

/// A new file; nothing when the driver cannot make it.
DatasetPtr create_dataset(const char* driver, const std::string& path, const std::vector<std::string>& options = {});

struct LayerWriteOptions {
  bool spatial_index = false;          ///< for GeoPackage
  bool short_names = false;            ///< column names of at most ten characters (Shapefile)
  bool geometry_only = false;          ///< no columns (DXF)
  bool round_values = false;           ///< to the columns' decimals (formats of text)
  std::vector<std::string> creation;   ///< further layer options
};

/// Adds a layer to the data set; errors when it cannot be written whole.
Issues write_layer(GDALDataset& dataset, const Layer& layer, const LayerWriteOptions& options);

/// Unique column names of at most ten characters, in the order of the columns: the documented short names of Shapefiles.
std::vector<std::string> short_column_names(const std::vector<LayerColumn>& columns);

}  // namespace stemwise
