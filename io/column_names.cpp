#include "io/column_names.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <vector>

namespace stemwise {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::array<const char*, column_kind_count> kind_words = {
    "x", "y", "z", "lon", "lat", "azimuth", "distance", "dbh", "circumference", "dbh_approximation", "height", "id", "species",
    "status", "date", "plot", "axis_x", "axis_y", "axis_z", "number_clusters", "reconstructed", "score", "quadrat", "local_x", "local_y"};

/// Pairs of position columns, best first; within one file the first that varies from row to row is taken.
const std::vector<std::pair<std::string_view, std::string_view>>& position_pairs() {
  static const std::vector<std::pair<std::string_view, std::string_view>> pairs = {
      {"geometryx", "geometryy"}, {"fieldxpj", "fieldypj"}, {"x", "y"}, {"gx", "gy"}, {"px", "py"}, {"xfield", "yfield"},
      {"locationx", "locationy"}, {"xcoord", "ycoord"}, {"xcoordinate", "ycoordinate"}, {"coordx", "coordy"}, {"coorx", "coory"},
      {"koordx", "koordy"}, {"treex", "treey"}, {"xtree", "ytree"}, {"xtreebase", "ytreebase"}, {"treelocationx", "treelocationy"}, {"stemx", "stemy"}, {"xstem", "ystem"}, {"posx", "posy"},
      {"xpos", "ypos"}, {"positionx", "positiony"}, {"pointx", "pointy"}, {"centerx", "centery"}, {"centrex", "centrey"},
      {"xc", "yc"}, {"basex", "basey"}, {"xbase", "ybase"}, {"localx", "localy"}, {"xlocal", "ylocal"}, {"fieldx", "fieldy"},
      {"tlsx", "tlsy"}, {"xk", "yk"}, {"easting", "northing"}, {"eastings", "northings"}, {"east", "north"}, {"utme", "utmn"},
      {"eutm", "nutm"}, {"utmx", "utmy"}, {"xutm", "yutm"}, {"utmeasting", "utmnorthing"}, {"eastingutm", "northingutm"},
      {"rechtswert", "hochwert"}, {"rw", "hw"}, {"ost", "nord"}, {"este", "norte"}, {"est", "nord"}, {"fielde", "fieldn"}, {"e", "n"}};
  return pairs;
}

const Words& names_of(ColumnKind kind) {
  static const std::array<Words, column_kind_count> names = [] {
    std::array<Words, column_kind_count> n;
    const auto set = [&n](ColumnKind k, Words words) { n[static_cast<std::size_t>(k)] = std::move(words); };
    using K = ColumnKind;
    set(K::z, {"geometryz", "z", "locationz", "gz", "pz", "zbase", "basez", "ztreebase", "treelocationz", "elevation", "elev", "groundz", "terrainz", "zcoord", "zcoordinate", "altitude"});
    set(K::lon, {"lon", "long", "longitude", "lng", "londd", "longdd", "longitud", "laenge", "laengengrad", "wgs84lon", "londeg"});
    set(K::lat, {"lat", "latitude", "latdd", "latitud", "breite", "breitengrad", "wgs84lat", "latdeg"});
    set(K::azimuth, {"azimuth", "azimut", "azim", "azi", "az", "bearing", "azimuthdeg", "azimuthdegrees", "rumbo", "richtung", "horizontalangle"});
    set(K::distance, {"hdist", "horizontaldistance", "horizdist", "hordist", "distance", "dist", "distanz", "entfernung", "distancia", "etaisyys", "distanceraw"});
    set(K::dbh, {"dbh", "dbhob", "bhd", "d130", "d13", "dhp", "dap", "diameterbh", "diameterbreastheight", "diameteratbreastheight", "dbhmeas",
                 "brusthohendurchmesser", "brusthoehendurchmesser", "stemdiameter", "treediameter", "diameter", "diametro", "diametre",
                 "durchmesser", "diam", "dia", "lapimitta", "d"});
    set(K::circumference, {"cbh", "gbh", "cap", "circumference", "circ", "girth", "umfang", "perimeter", "perimetre", "perimetro", "circonference", "circonf", "circunferencia", "c130", "c13"});
    set(K::dbh_approximation, {"dbhapproximation", "dbhapprox"});
    set(K::height, {"height", "treeheight", "totalheight", "heighttotal", "treeht", "ht", "h", "th", "tht", "actualht", "hohe", "hoehe", "baumhohe",
                    "altura", "alturatotal", "hauteur", "pituus", "htotal"});
    set(K::id, {"stemid", "stemindex", "idstem", "treeid", "idtree", "idarbol", "arbol", "id", "tag", "treetag", "tagnum", "tagno", "tagnumber",
                "tree", "treeno", "treenumber", "treenum", "treenr", "baumnr", "baumnummer", "baumid", "baum", "treefieldnum", "puunro",
                "arbre", "arvore", "idarvore", "albero", "number", "num", "nummer", "nr", "no", "n", "pos", "name", "label", "objectid", "fid"});
    set(K::species, {"species", "speciescode", "speciesname", "spcode", "sp", "spp", "sps", "spcd", "baumart", "art", "essence", "espece",
                     "especie", "especies", "scientificname", "latinname", "treespecies", "mnemonic", "puulaji"});
    set(K::status, {"status", "livedead", "alivedead", "statuscd", "dfstatus", "treestatus", "stemstatus", "codealive", "alive", "livingstatus",
                    "live", "vitality", "vitalstatus", "etat", "estado", "zustand"});
    set(K::date, {"exactdate", "date", "measdate", "measurementdate", "datemeasured", "surveydate", "censusdate", "inventorydate",
                  "datum", "fecha", "data", "aufnahmedatum", "messdatum", "erhebungsdatum", "inventurdatum", "datemesure", "datedemesure", "dateinventaire", "datereleve",
                  "fechamedicion", "fechademedicion", "fechainventario", "datamedicao", "datamisura", "datarilievo", "year", "censusyear", "measyear", "surveyyear", "invyr", "jahr", "annee", "ano", "anio"});
    set(K::plot, {"plot", "plotid", "plotno", "plotnumber", "plotnum", "plotnr", "plotname", "fieldplot", "site", "siteid", "stand", "standid",
                  "parcela", "idparcela", "parcelle", "parzelle", "probekreis", "koeala", "subplot", "subp", "subplotid"});
    set(K::axis_x, {"axisx", "axis02"});
    set(K::axis_y, {"axisy", "axis12"});
    set(K::axis_z, {"axisz", "axis22"});
    set(K::number_clusters, {"numberclusters"});
    set(K::reconstructed, {"reconstructed"});
    set(K::score, {"score", "scores"});
    set(K::quadrat, {"quadrat", "quadratname", "quad"});
    set(K::local_x, {"lx", "qx"}), set(K::local_y, {"ly", "qy"});
    return n;
  }();
  return names[static_cast<std::size_t>(kind)];
}

/// Latin letters with accents to plain ones; what has none is dropped.
char plain_letter(std::string_view text, std::size_t& i) {
  static const std::vector<std::pair<std::string_view, char>> letters = {
      {"ä", 'a'}, {"á", 'a'}, {"à", 'a'}, {"â", 'a'}, {"ã", 'a'}, {"å", 'a'}, {"ö", 'o'}, {"ó", 'o'}, {"ò", 'o'}, {"ô", 'o'}, {"õ", 'o'}, {"ü", 'u'},
      {"ú", 'u'}, {"ù", 'u'}, {"û", 'u'}, {"é", 'e'}, {"è", 'e'}, {"ê", 'e'}, {"ë", 'e'}, {"í", 'i'}, {"ì", 'i'}, {"î", 'i'}, {"ï", 'i'}, {"ñ", 'n'}, {"ç", 'c'},
      {"š", 's'}, {"č", 'c'}, {"ž", 'z'}, {"Ä", 'a'}, {"Á", 'a'}, {"À", 'a'}, {"Â", 'a'}, {"Ã", 'a'}, {"Å", 'a'}, {"Ö", 'o'}, {"Ó", 'o'}, {"Ò", 'o'}, {"Ô", 'o'},
      {"Õ", 'o'}, {"Ü", 'u'}, {"Ú", 'u'}, {"Ù", 'u'}, {"Û", 'u'}, {"É", 'e'}, {"È", 'e'}, {"Ê", 'e'}, {"Ë", 'e'}, {"Í", 'i'}, {"Ì", 'i'}, {"Î", 'i'},
      {"Ï", 'i'}, {"Ñ", 'n'}, {"Ç", 'c'}, {"Š", 's'}, {"Č", 'c'}, {"Ž", 'z'}};
  for (const auto& [accented, plain] : letters) {
    if (text.substr(i).starts_with(accented)) {
      i += accented.size() - 1;
      return plain;
    }
  }
  return 0;
}

std::optional<int> census_year(std::string_view digits) {
  if (digits.size() != 4 || !std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) return std::nullopt;
  const int year = std::stoi(std::string(digits));
  return year >= 1850 && year <= 2100 ? std::optional(year) : std::nullopt;
}

/// "d14", "dbh98", "dbh2013": a diameter of one of several censuses.
void split_census_diameter(ColumnName& name) {
  const std::size_t digits_from = name.base.find_first_of("0123456789");
  if (name.year || digits_from == std::string::npos) return;
  const std::string stem = name.base.substr(0, digits_from);
  const std::string digits = name.base.substr(digits_from);
  if (stem != "d" && stem != "dbh" && stem != "diam" && stem != "bhd" && stem != "dap" && stem != "dhp" && stem != "status") return;
  if (const auto year = census_year(digits)) {
    name.year = year;
  } else if (digits.size() == 2 && std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; }) && digits != "13") {
    const int two = std::stoi(digits);
    name.year = two < 50 ? 2000 + two : 1900 + two;
  }
  if (name.year) name.base = stem == "status" ? "status" : "dbh";
}

/// Takes "(cm)" or "[44]" out of the header; a unit in it is returned.
std::string take_brackets(std::string& header) {
  std::string unit;
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')}) {
    const std::size_t from = header.find(open);
    if (from == std::string::npos) continue;
    const std::size_t to = header.find(close, from);
    const std::string inside = header.substr(from + 1, to == std::string::npos ? to : to - from - 1);
    if (const std::string found = unit_from_word(inside); !found.empty()) unit = found;
    header.erase(from, to == std::string::npos ? to : to - from + 1);
  }
  return unit;
}

}  // namespace

/// Lower-case words of letters and digits; "ﬁ" of a byte-order mark read as text and other oddities drop out.
std::vector<std::string> plain_words(std::string_view text) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (std::isalnum(c) != 0 && c < 0x80) {
      words.back().push_back(static_cast<char>(std::tolower(c)));
    } else if (const char plain = c >= 0x80 ? plain_letter(text, i) : '\0'; plain != 0) {
      words.back().push_back(plain);
    } else if (c < 0x80 && !words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

const char* to_string(ColumnKind kind) { return kind_words[static_cast<std::size_t>(kind)]; }

std::optional<ColumnKind> column_kind_from(std::string_view word) {
  for (std::size_t i = 0; i < kind_words.size(); ++i) {
    if (word == kind_words[i]) return static_cast<ColumnKind>(i);
  }
  return std::nullopt;
}

std::string unit_from_word(std::string_view word) {
  static const std::vector<std::pair<std::string_view, Words>> units = {
      {"m", {"m", "meter", "meters", "metre", "metres", "metros"}}, {"dm", {"dm"}}, {"cm", {"cm", "centimeter", "centimeters", "centimetre", "centimetres"}},
      {"mm", {"mm", "millimeter", "millimeters", "millimetre", "millimetres"}}, {"ft", {"ft", "feet", "foot"}},
      {"in", {"in", "inch", "inches"}}, {"deg", {"deg", "degree", "degrees", "°", "grad"}}, {"gon", {"gon", "grads", "gons"}},
      {"rad", {"rad", "radian", "radians"}}};
  std::string plain;
  for (const char c : word) {
    if (c != ' ' && c != '.') plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  }
  for (const auto& [unit, words] : units) {
    if (std::find(words.begin(), words.end(), plain) != words.end()) return std::string(unit);
  }
  return {};
}

double metres_per(std::string_view unit) {
  static const std::vector<std::pair<std::string_view, double>> factors = {{"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};
  for (const auto& [name, factor] : factors) {
    if (unit == name) return factor;
  }
  return 0.0;
}

double radians_per(std::string_view unit) {
  if (unit == "deg") return std::numbers::pi / 180.0;
  if (unit == "gon") return std::numbers::pi / 200.0;
  return unit == "rad" ? 1.0 : 0.0;
}

ColumnName parse_column_name(std::string_view header) {
  ColumnName name;
  std::string text(header);
  name.unit = take_brackets(text);
  std::vector<std::string> words = plain_words(text);
  if (words.size() > 1) {
    if (const std::string unit = unit_from_word(words.back()); !unit.empty()) {
      if (name.unit.empty()) name.unit = unit;
      words.pop_back();
    }
  }
  if (words.size() > 1) {
    if ((name.year = census_year(words.back()))) words.pop_back();
  }
  for (const std::string& word : words) name.base += word;
  for (const std::string_view unit : {"cm", "mm"}) {  // "DBHcm"
    if (name.unit.empty() && name.base.size() > 3 && name.base.ends_with(unit) && name.base.find('d') != std::string::npos) {
      name.unit = unit;
      name.base.resize(name.base.size() - 2);
    }
  }
  split_census_diameter(name);
  return name;
}

std::optional<int> name_rank(const ColumnName& name, ColumnKind kind) {
  const Words& names = names_of(kind);
  const auto at = std::find(names.begin(), names.end(), name.base);
  if (at == names.end()) return std::nullopt;
  return static_cast<int>(at - names.begin());
}

std::optional<PairName> position_partner(const std::string& base) {
  const auto& pairs = position_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].first == base) return PairName{std::string(pairs[i].second), static_cast<int>(i)};
  }
  return std::nullopt;
}

}  // namespace stemwise
