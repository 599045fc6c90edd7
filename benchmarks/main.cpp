#include <cstring>

#include <benchmark/benchmark.h>

namespace stemwise::benchmarks {
void add_stages();
void add_scaling();
}  // namespace stemwise::benchmarks

/// `--scaling` in front: the growth with the database (about 6 GB and some minutes) instead of the stages.
int main(int argc, char** argv) {
  const bool scaling = argc > 1 && std::strcmp(argv[1], "--scaling") == 0;
  if (scaling) {
    argv[1] = argv[0];
    --argc;
    ++argv;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  scaling ? stemwise::benchmarks::add_scaling() : stemwise::benchmarks::add_stages();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
