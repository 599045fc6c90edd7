#pragma once
#include <string>

#include "app/commands/evaluation_output.hpp"

namespace stemwise {

/// precision_recall, position_error, rotation_error and query_time, each as .png and .svg, into a folder that is made. File
/// names begin with `prefix`.
Issues write_evaluation_plots(const treeloc::Evaluation& evaluation, const EvaluationAbout& about, const std::string& folder,
                              const std::string& prefix = "");

}  // namespace stemwise
