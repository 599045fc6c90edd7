#pragma once
#include <string>

namespace stemwise::platform {

/// The person's home folder, "" when nothing says it.
std::string home_folder();
/// Where settings of ours lie: $XDG_CONFIG_HOME/stemwise, else ~/.config/stemwise. Not made here.
std::string config_folder();
/// Where things of ours lie that can be made again: $XDG_CACHE_HOME/stemwise, else ~/.cache/stemwise; "" without a home. Not
/// made here.
std::string cache_folder();
/// Tells one build of this program from another; "" when that cannot be seen.
std::string program_stamp();
/// Login name, for the edit log.
std::string user_name();
/// "22 Nov 2026, 05:00" in this machine's time zone, from "2026-11-22T05:00:30Z"; what was given where it is none.
std::string local_time(const std::string& utc);
int process_id();

}  // namespace stemwise::platform
