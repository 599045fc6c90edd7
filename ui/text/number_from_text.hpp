#pragma once
#include <optional>
#include <string>

namespace stemwise::ui {

/// A number as people type it: 1.5 and 1,5; 1.234,5 and 1,234.5 and 1 234,5 and 1'234.5 with thousands apart (then in groups of
/// three); a true minus; 1e-3. Nothing where the whole text is not one finite number, or could be read in two ways that differ
/// by more than the sign of the decimals ("1.37,5").
std::optional<double> number_from_text(const std::string& text);

}  // namespace stemwise::ui
