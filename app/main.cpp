#include <string>
#include <vector>

#include "app/command_line.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return static_cast<int>(stemwise::run_command_line(arguments));
}
