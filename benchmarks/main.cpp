#include <benchmark/benchmark.h>

namespace stemwise::benchmarks {
void add_stages();
}

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  stemwise::benchmarks::add_stages();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
