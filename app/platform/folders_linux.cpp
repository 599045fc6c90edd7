#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

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

std::string cache_folder() {
  if (const std::string base = environment("XDG_CACHE_HOME"); !base.empty()) return base + "/stemwise";
  const std::string home = home_folder();
  return home.empty() ? "" : home + "/.cache/stemwise";
}

std::string program_stamp() {
  struct stat about {};
  if (stat("/proc/self/exe", &about) != 0) return "";
  return std::to_string(about.st_size) + " " + std::to_string(about.st_mtim.tv_sec) + "." + std::to_string(about.st_mtim.tv_nsec) + " " + std::to_string(about.st_ino);
}

std::string user_name() {
  if (const std::string user = environment("USER"); !user.empty()) return user;
  const passwd* entry = getpwuid(getuid());
  return entry != nullptr ? entry->pw_name : "unknown";
}

std::string local_time(const std::string& utc) {
  std::tm parts{};
  if (std::sscanf(utc.c_str(), "%d-%d-%dT%d:%d", &parts.tm_year, &parts.tm_mon, &parts.tm_mday, &parts.tm_hour, &parts.tm_min) != 5) return utc;
  parts.tm_year -= 1900;
  parts.tm_mon -= 1;
  const std::time_t time = timegm(&parts);
  std::tm local{};
  if (localtime_r(&time, &local) == nullptr) return utc;
  static constexpr const char* months[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%d %s %d, %02d:%02d", local.tm_mday, months[local.tm_mon % 12], local.tm_year + 1900, local.tm_hour, local.tm_min);
  return text.data();
}

int process_id() { return static_cast<int>(getpid()); }

}  // namespace stemwise::platform
