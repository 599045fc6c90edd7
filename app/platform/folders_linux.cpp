#include <pwd.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "app/platform/folders.hpp"

namespace stemwise::platform {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

std::string home_folder() {
  if (const std::string home = environment("HOME"); !home.empty()) return home;
  const passwd* entry = getpwuid(getuid());
  return entry != nullptr && entry->pw_dir != nullptr ? entry->pw_dir : "";
}

std::string config_folder() {
  const std::string base = environment("XDG_CONFIG_HOME");
  return (base.empty() ? home_folder() + "/.config" : base) + "/stemwise";
}

std::string user_name() {
  if (const std::string user = environment("USER"); !user.empty()) return user;
  const passwd* entry = getpwuid(getuid());
  return entry != nullptr ? entry->pw_name : "unknown";
}

int process_id() { return static_cast<int>(getpid()); }

bool process_runs(int id) { return id > 0 && (kill(id, 0) == 0 || errno == EPERM); }

}  // namespace stemwise::platform
