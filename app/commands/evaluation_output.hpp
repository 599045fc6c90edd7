#pragma once
#include <string>

#include "core/treeloc/evaluate.hpp"

namespace stemwise {

/// What an evaluation was of, beside its result.
struct EvaluationAbout {
  std::string mode;  ///< intra, inter
  std::string method;
  std::string query;
  std::string map;
  std::string map_mode = "frames";
  int threads = 1;
  double read_s = 0.0;
  double describe_s = 0.0;  ///< preparing all scenes and making the database's descriptors
  double index_s = 0.0;     ///< of it: making the database's descriptors
  double cache_write_s = 0.0;
  bool query_from_cache = false, map_from_cache = false;
  double peak_rss_mb = 0.0;
};

/// The JSON of cli.md.
std::string evaluation_json(const treeloc::Evaluation& evaluation, const EvaluationAbout& about);
/// A header and a row per query that counts.
std::string evaluation_csv(const treeloc::Evaluation& evaluation);
/// A few lines for a person.
std::string evaluation_text(const treeloc::Evaluation& evaluation, const EvaluationAbout& about);

}  // namespace stemwise
