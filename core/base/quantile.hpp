#pragma once
#include <vector>

namespace stemwise {

/// Quantile q (0..1) with linear interpolation between order statistics (Hyndman and Fan 1996, type 7). `sorted` ascending,
/// not empty.
double quantile_of_sorted(const std::vector<double>& sorted, double q);
/// Takes the values by copy, since it must order them. 0 when empty.
double median(std::vector<double> values);

}  // namespace stemwise
