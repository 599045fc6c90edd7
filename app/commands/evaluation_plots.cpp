#include "app/commands/evaluation_plots.hpp"

#include <filesystem>
#include <utility>

#include "core/survey/evaluation_charts.hpp"
#include "render/chart_painter.hpp"

namespace stemwise {

Issues write_evaluation_plots(const treeloc::Evaluation& evaluation, const EvaluationAbout& about, const std::string& folder,
                              const std::string& prefix) {
  namespace fs = std::filesystem;
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return {{Severity::error, folder, 0, "", "cannot be made: " + code.message(), ""}};
  const std::string title = about.query + (about.mode == "inter" ? " in " + about.map : "") + ", " + about.method;
  const std::pair<const char*, ChartModel> charts[] = {{"precision_recall", precision_recall_chart(evaluation, title)},
                                                       {"position_error", position_error_chart(evaluation, title)},
                                                       {"rotation_error", rotation_error_chart(evaluation, title)},
                                                       {"query_time", query_time_chart(evaluation, title)}};
  for (const auto& [name, chart] : charts) {
    for (const bool is_png : {true, false}) {
      const render::ChartStyle style{.size = {is_png ? 1280 : 640, is_png ? 720 : 360}, .scale = is_png ? 2.0 : 1.0, .selected = {}};
      const std::string file = prefix + name + (is_png ? ".png" : ".svg");
      const auto written = render::write_chart(chart, style, (fs::path(folder) / file).string());
      if (!written) return written.issues;
    }
  }
  return {};
}

}  // namespace stemwise
