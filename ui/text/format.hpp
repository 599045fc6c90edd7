#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/date.hpp"

namespace stemwise::ui {

// Numbers as people read them: a true minus sign, thin spaces in coordinates, a dash for what is not known.

inline constexpr const char* dash = "–";

std::string fixed(double value, int decimals);
std::string count_text(std::int64_t count);                   ///< "4,120"
std::string plural(std::int64_t count, const char* one, const char* many);  ///< "4,120 stems"
std::string dbh_text(std::optional<double> dbh_m);            ///< cm with one decimal: "31.4"
std::string change_text(std::optional<double> change_m);      ///< cm, signed: "+1.2", "−4.2"
std::string distance_text(double distance_m);                 ///< "0.31 m"
std::string residual_text(double residual_m);                 ///< "7.1 cm"
std::string grouped(double value, int decimals);              ///< thin spaces every three digits: "5 402 096.0"
std::string date_text(Date date);                             ///< "1 Apr 2013"
std::string percent_text(double share, int decimals = 0);     ///< "94 %"
std::string duration_text(double seconds);                    ///< "4 s", "2 min 10 s"
std::string flag_words(std::string flag);                     ///< "implausible growth" of implausible_growth
std::string sentence(std::string text);                       ///< with a capital at its beginning
/// "12 s ago", "5 min ago".
std::string ago_text(double seconds);

}  // namespace stemwise::ui
