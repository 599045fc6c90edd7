#pragma once
#include <string>

namespace stemwise::render {

/// 1, 2 or 5 times a power of ten, at least `rough` (a step for ticks); 1 for what is not positive.
double nice_step(double rough);
/// Decimals needed to write multiples of a step.
int decimals_of(double step);
/// With a true minus sign.
std::string number_text(double value, int decimals);
/// "+1.2", "0.0", "−0.4".
std::string signed_text(double value, int decimals);

/// "3,544".
std::string grouped_text(long long value);

}  // namespace stemwise::render
