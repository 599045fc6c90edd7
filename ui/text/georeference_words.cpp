#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {

std::string crs_words(const Georeference& georeference) {
  if (georeference.kind == GeoreferenceKind::none) return "";
  if (georeference.kind == GeoreferenceKind::crs) return "EPSG:" + std::to_string(georeference.epsg);
  const auto utm = utm_from_geodetic(georeference.origin, georeference.origin);
  if (!utm) return "WGS 84";
  return "UTM " + std::to_string(utm->zone) + (utm->north ? "N" : "S") + ", EPSG:" + std::to_string(utm->epsg());
}

}  // namespace stemwise::ui
