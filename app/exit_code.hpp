#pragma once

namespace stemwise {

/// What the process says to its caller (cli.md).
enum class ExitCode : int {
  done = 0,             ///< warnings allowed
  failed = 1,           ///< alignment refused, nothing to do, output not writable
  usage = 2,            ///< the command line itself is wrong
  unusable_input = 3,   ///< an input has no usable row or is not what it claims
  interrupted = 130,    ///< Ctrl+C
};

}  // namespace stemwise
