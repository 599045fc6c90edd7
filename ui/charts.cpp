#include "ui/charts.hpp"

namespace stemwise::ui {
namespace {

struct Words {
  const char* word;
  const char* label;
};
constexpr std::array<Words, chart_count> words{{{"dbh-over-time", "DBH over time"},
                                                {"dbh-classes", "DBH classes"},
                                                {"dbh-change", "DBH change"},
                                                {"dbh-change-against-dbh", "DBH change against DBH"},
                                                {"residuals", "Residual distances"},
                                                {"residual-directions", "Residual directions"}}};

}  // namespace

const char* chart_word(Chart chart) { return words[static_cast<std::size_t>(chart)].word; }
const char* chart_label(Chart chart) { return words[static_cast<std::size_t>(chart)].label; }

}  // namespace stemwise::ui
