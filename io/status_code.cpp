#include "io/status_code.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "io/column_names.hpp"

namespace stemwise {
namespace {

using Words = std::vector<std::string_view>;

/// Lower case, accents removed, one blank between words.
const Words& alive_words() {
  static const Words words = {"a",      "l",     "li",     "lb",       "alive",      "live",       "living",     "true",         "yes",         "y",       "t",    "vivo",
                              "viva",   "vivos", "vivas",  "vivant",   "vivante",    "vif",        "vive",       "lebend",       "lebendig",    "lebt",    "lebende",
                              "elava",  "as",    "ll",     "au",       "liv",        "survivor",   "healthy",    "gesund",       "sain",        "sano",    "sana",
                              "dying",  "wahr",  "ja",     "oui",      "vrai",       "si",         "sim",        "broken below"};
  return words;
}

const Words& dead_words() {
  static const Words words = {"d",          "dead",     "sn",         "snag",       "dn",          "dc",          "ds",        "dt",       "g",        "gone",      "false",
                              "no",         "n",        "f",          "falsch",     "nein",        "non",         "faux",      "falso",    "mort",     "morte",     "morts",
                              "muerto",     "muerta",   "muertos",    "morto",      "morta",       "mortos",      "tot",       "tote",     "toter",    "totes",     "kuollut",
                              "abgestorben", "abgestorbene", "abgestorbener", "died", "deceased",  "killed",      "mortality", "log",      "fallen",   "down",      "downed",
                              "umgefallen", "umgesturzt", "umgestuerzt", "totholz",  "stehendtot", "tombe",       "tombee",    "caido",    "caida",    "stem dead", "stem gone"};
  return words;
}

const Words& removed_words() {
  static const Words words = {"cut",      "cut down", "removed",  "stump",    "cut stump", "harvested", "harvest",  "felled",     "logged",   "thinned", "extracted",
                              "salvaged", "entnommen", "entfernt", "gefallt", "gefaellt",  "geerntet",  "geschlagen", "genutzt",  "stubben",  "stubbe",  "stumpf",
                              "baumstumpf", "coupe",  "coupee",   "abattu",   "abattue",   "exploite",  "exploitee", "souche",    "enleve",   "enlevee", "preleve",
                              "prelevee", "recolte",  "recoltee", "cortado",  "cortada",   "talado",    "talada",   "tocon",      "extraido", "extraida", "aprovechado",
                              "cosechado", "cosechada", "toco",   "removido", "removida",  "colhido",   "colhida",  "abatido",    "abatida",  "tagliato", "tagliata",
                              "ceppaia",  "abbattuto", "abbattuta", "poistettu", "hakattu"};
  return words;
}

const Words& missing_words() {
  static const Words words = {"missing",  "not found",  "notfound",  "not seen",  "not observed", "unfound",       "lost",           "prior",         "vermisst",
                              "fehlt",    "fehlend",    "nicht gefunden", "nicht auffindbar", "manquant", "manquante", "non trouve", "disparu",       "introuvable",
                              "absent",   "ausente",    "no encontrado", "no encontrada", "desaparecido", "desaparecida", "nao encontrado", "nao encontrada", "faltante"};
  return words;
}

bool is_in(const Words& words, std::string_view word) { return std::find(words.begin(), words.end(), word) != words.end(); }

StemStatus status_from_word(std::string_view word) {
  if (is_in(alive_words(), word)) return StemStatus::alive;
  if (is_in(removed_words(), word)) return StemStatus::removed;
  if (is_in(missing_words(), word)) return StemStatus::missing;
  return is_in(dead_words(), word) ? StemStatus::dead : StemStatus::unknown;
}

/// "dead top", "not dead", "half alive": said of a part, or denied.
bool is_qualified(const std::vector<std::string>& words) {
  static const Words qualifiers = {"not",  "nicht", "no",     "non",    "nao",  "pas",   "half",  "halb",   "partly", "partially", "teilweise", "top", "tops",
                                   "crown", "krone", "branch", "branches", "ast", "cime", "wipfel", "almost", "fast",   "or",     "oder",      "dbh", "bark"};
  return std::any_of(words.begin(), words.end(), [](const std::string& w) { return is_in(qualifiers, w); });
}

/// "standing dead", "dead, fallen", "mort sur pied", "alive (leaning)": what the words agree on.
StemStatus status_from_phrase(const std::vector<std::string>& words) {
  if (words.size() < 2 || is_qualified(words)) return StemStatus::unknown;
  StemStatus said = StemStatus::unknown;
  for (const std::string& word : words) {
    const StemStatus one = word.size() < 3 ? StemStatus::unknown : status_from_word(word);
    if (one == StemStatus::unknown) continue;
    if (said != StemStatus::unknown && said != one) return StemStatus::unknown;
    said = one;
  }
  return said;
}

}  // namespace

StemStatus status_from_code(std::string_view code, bool numbers_from_one) {
  if (code == "1" || code == "1.0") return StemStatus::alive;
  if (code == "0" || code == "0.0") return numbers_from_one ? StemStatus::unknown : StemStatus::dead;
  if (code == "2" || code == "3") return numbers_from_one ? StemStatus::dead : StemStatus::unknown;
  const std::vector<std::string> words = plain_words(code);
  std::string whole;
  for (const std::string& word : words) whole += (whole.empty() ? "" : " ") + word;
  if (const StemStatus said = status_from_word(whole); said != StemStatus::unknown) return said;
  if (words.size() == 1 && (whole.starts_with("dead") || whole.starts_with("gone"))) return StemStatus::dead;
  if (words.size() == 1 && (whole.starts_with("alive") || whole.starts_with("live"))) return StemStatus::alive;
  return status_from_phrase(words);
}

}  // namespace stemwise
