#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "core/base/field.hpp"

namespace stemwise {

/// What every command takes.
struct CommonOptions {
  int threads = 0;  ///< 0: all of the machine
  std::uint64_t seed = 0;
  std::string config;                 ///< JSON file of settings by their keys
  std::vector<std::string> settings;  ///< key=value, later ones win, also over the file
  std::string json;                   ///< where the machine-readable result goes; "-": stdout; empty: nowhere
  bool quiet = false;
};

/// One run of one command: its common options, the person in front of it, and whether Ctrl+C was pressed.
struct Session {
  const CommonOptions& common;
  Console& console;
  const std::atomic<bool>& cancel;

  Progress progress() { return console.progress(&cancel); }
  /// Applies --config, then --set. On anything wrong: says so and returns the exit code.
  ExitCode apply_settings(Fields fields);
  /// Writes the machine-readable result where --json wants it; nothing without --json.
  ExitCode write_json(const std::string& text);
};

/// The settings as given, by key, before anybody checked the keys. Fails for a broken --config or a --set without "=".
struct GivenSettings {
  std::vector<std::pair<std::string, std::string>> values;
  Issues issues;
};
GivenSettings given_settings(const CommonOptions& common);

/// Issues about settings (their key stands in `column`) in the words of the command line: "setting vote.cell_m: ...". `prefix`: what
/// the keys lack in front.
Issues as_settings(Issues issues, const std::string& prefix = "");

/// A whole file or nothing; "-" is stdout.
Issues write_result(const std::string& path, const std::string& text);

}  // namespace stemwise
