#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace stemwise {

/// How a file writes its numbers.
struct NumberStyle {
  bool decimal_comma = false;
  bool certain = true;  ///< false: nothing but numbers like 1,234 was met
};

/// Gathers, number by number, what tells decimal from thousands signs.
class NumberStyleVotes {
 public:
  void add(std::string_view text);
  /// `comma_delimits`: the file separates its fields by commas, so a doubtful 1,234 is one thousand.
  NumberStyle decide(bool comma_delimits) const;

 private:
  int point_decimal_ = 0;
  int comma_decimal_ = 0;
  int doubtful_comma_ = 0;
};

/// What a cell that should hold a number holds.
struct Quantity {
  enum class Kind { number, missing, not_a_number, bad };
  Kind kind = Kind::missing;
  double value = 0.0;
  std::string_view unit;  ///< written behind the number: "m", "cm", "deg", ...; points into a literal
};

/// Reads "12.5", "1 234,5", "2,8m", "155°". Empty cells, NA, null, - and the like are `missing`; NaN and infinities are
/// `not_a_number`; anything else is `bad`.
Quantity parse_quantity(std::string_view cell, NumberStyle style);

/// NA, N/A, null, none, nm, -, ... and nothing at all.
bool is_missing_mark(std::string_view cell);

}  // namespace stemwise
