#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stemwise {

/// Seeded random numbers that are the same on every platform and library (the standard distributions are not).
/// Generator: SplitMix64 (Steele, Lea, Flood 2014).
class Random {
  __extension__ using Wide = unsigned __int128;

 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      // Mixed, not multiplied by the step: seeds that are steps apart would give the same numbers, only shifted.
      : state_(mixed(seed + 0x632BE59BD9B4E019ULL) ^ mixed(stream + 0xD1B54A32D192ED03ULL) * 3) {}

  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15ULL); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, n).
  std::uint64_t below(std::uint64_t n) { return static_cast<std::uint64_t>((static_cast<Wide>(next()) * n) >> 64); }
  double normal() {  // Box-Muller, one of the pair kept
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }
  double normal(double mean, double sd) { return mean + sd * normal(); }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace stemwise
