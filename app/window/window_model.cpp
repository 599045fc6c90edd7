#include "app/window/window_model.hpp"

#include <cstdlib>
#include <ctime>

#include "app/platform/folders.hpp"

namespace stemwise {

EditStamp stamp_now(std::string note) {
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) now = static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10));
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {platform::user_name(), text, std::move(note)};
}

}  // namespace stemwise
