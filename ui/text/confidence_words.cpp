#include "ui/text/confidence_words.hpp"

#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::string dbh_words(const MatchRow& match) {
  if (!match.dbh_a_m || !match.dbh_b_m) return "no DBH to compare";
  switch (match.change) {
    case ChangeClass::within_error: return "DBH agrees within error";
    case ChangeClass::grew: return "DBH " + fixed((*match.dbh_b_m - *match.dbh_a_m) * 100.0, 1) + " cm more";
    case ChangeClass::shrank: return "DBH " + fixed((*match.dbh_a_m - *match.dbh_b_m) * 100.0, 1) + " cm less";
    case ChangeClass::unknown: break;
  }
  return "DBH not compared";
}

}  // namespace

std::string confidence_words(const MatchRow& match) {
  if (match.state == MatchState::accepted || match.state == MatchState::linked) return "a person said so";
  std::string words = distance_text(match.distance_m) + " apart; " + dbh_words(match);
  words += match.second_distance_m ? "; second candidate " + distance_text(*match.second_distance_m) + " away" : "; no second candidate";
  return words;
}

}  // namespace stemwise::ui
