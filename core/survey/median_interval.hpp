#pragma once
#include <array>
#include <vector>

namespace stemwise {

/// 95 % interval of the true median of changes that were measured with errors of mean 0 on both sides; metres in, metres out.
///
/// Errors do not move a mean, but they draw the median of a skewed stand towards it, whatever the number of stems: the order
/// statistics of the measured changes then hold a wrong median ever more surely. So the interval joins two:
/// - ranks n/2 -+ 0.98 sqrt(n) of the measured changes (normal approximation of the binomial);
/// - the median without that pull -+ 1.96 of its standard error (jackknife over groups). The pull follows from the skewness,
///   which symmetric errors leave as it is: mean minus median is m3 / (6 variance) to first order (Cornish and Fisher 1938),
///   once with and once without the variance of the errors, which the spread below the median tells.
///
/// `changes_m` in any order, which makes the groups: independent of the values. Below 20 stems only the ranks count. Empty: both 0.
std::array<double, 2> median_interval(const std::vector<double>& changes_m);

}  // namespace stemwise
