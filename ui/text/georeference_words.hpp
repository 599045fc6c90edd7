#pragma once
#include <string>

#include "core/geodesy/georeference.hpp"

namespace stemwise::ui {

/// The CRS that exports get by default: "UTM 32N, EPSG:32632"; "" for a project in local coordinates.
std::string crs_words(const Georeference& georeference);

}  // namespace stemwise::ui
