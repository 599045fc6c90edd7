#pragma once
#include <string>

#include "io/gdal_dataset.hpp"
#include "io/project_layers.hpp"

namespace stemwise {

// Only for .cpp files of io: names GDAL.

/// How QGIS should draw a layer (QML): trees by fate in the colours of spec/ui.md and sized by DBH, stems by inventory, links and
/// coverages as lines. Empty for tables.
std::string layer_qml(LayerKind kind, OGRLayer& layer);

}  // namespace stemwise
