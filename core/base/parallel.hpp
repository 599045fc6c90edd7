#pragma once
#include <cstddef>
#include <functional>

namespace stemwise {

/// Calls `work(i)` for every i in [0, count) on up to `threads` threads (0: all of the machine). Each i must write only
/// what is its own, so that the outcome is the same at any thread count. The first exception is thrown again here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work);
int hardware_threads();

}  // namespace stemwise
