#include "app/read_inputs.hpp"

#include <algorithm>
#include <filesystem>

#include "io/column_names.hpp"
#include "io/inventory_date.hpp"
#include "io/read_gis.hpp"
#include "io/read_inventory.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

/// An override split into whom it is for (empty: all) and what it says.
struct Targeted {
  std::string name;
  std::string text;
};

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// "2023:x=Easting". Behind `before` ("=" for --map and --unit) a colon belongs to the value.
Targeted split_target(const std::string& given, const std::vector<std::string>& names) {
  const auto colon = given.find(':');
  if (colon == std::string::npos || colon > given.find('=')) return {"", given};
  const std::string name = given.substr(0, colon);
  if (!is_among(name, names) && given.find('=') == std::string::npos) return {"", given};
  return {name, given.substr(colon + 1)};
}

Issue usage_error(const std::string& text, const std::string& help = "") { return {Severity::error, "", 0, "", text, help}; }

class OverrideReader {
 public:
  OverrideReader(const std::vector<std::string>& names, Issues& issues) : names_(names), issues_(issues) {}

  /// Calls `take(text)` for every override that is meant for `name`.
  template <class Take>
  void each(const std::vector<std::string>& given, const std::string& name, Take take) const {
    for (const std::string& one : given) {
      const Targeted target = split_target(one, names_);
      if (target.name.empty() || target.name == name) take(target.text);
    }
  }
  /// Overrides that name an inventory there is not, or lack their "=".
  void check(const char* option, const std::vector<std::string>& given, bool pairs) const {
    for (const std::string& one : given) {
      const Targeted target = split_target(one, names_);
      if (!target.name.empty() && !is_among(target.name, names_)) {
        issues_.push_back(usage_error(std::string(option) + " " + one + ": there is no inventory named " + target.name));
      }
      const auto sign = target.text.find('=');
      if (pairs && (sign == std::string::npos || sign == 0 || sign + 1 == target.text.size())) {
        issues_.push_back(usage_error(std::string(option) + " " + one + ": expected KEY=VALUE"));
      }
    }
  }

 private:
  const std::vector<std::string>& names_;
  Issues& issues_;
};

ReadOptions options_for(const std::string& name, const ReadOverrides& overrides, const OverrideReader& reader, Issues& issues) {
  ReadOptions options;
  const auto pair_into = [&issues](std::map<std::string, std::string>& into, const char* option) {
    return [&into, &issues, option](const std::string& text) {
      const std::string key = text.substr(0, text.find('='));
      if (!column_kind_from(key)) issues.push_back(usage_error(std::string(option) + " " + text + ": there is no column of ours named " + key, "for example dbh, x, y, z, id, species"));
      into[key] = text.substr(text.find('=') + 1);
    };
  };
  reader.each(overrides.map, name, pair_into(options.columns, "--map"));
  reader.each(overrides.unit, name, pair_into(options.units, "--unit"));
  for (const auto& [key, unit] : options.units)
    if (unit_from_word(unit).empty()) issues.push_back(usage_error("--unit " + key + "=" + unit + ": there is no such unit", "m, dm, cm, mm, ft, in, deg, gon or rad"));
  reader.each(overrides.sheet, name, [&](const std::string& text) { options.sheet = text; });
  reader.each(overrides.plot_column, name, [&](const std::string& text) { options.plot_column = text; });
  reader.each(overrides.plot, name, [&](const std::string& text) { options.plot = text; });
  reader.each(overrides.date, name, [&](const std::string& text) {
    options.date = parse_date(text);
    if (!options.date) issues.push_back(usage_error("--date " + text + " is not a date", "for example 2023-05-04"));
  });
  reader.each(overrides.status, name, [&](const std::string& text) {
    const auto status = stem_status_from(text.substr(text.rfind('=') + 1));
    if (!status) issues.push_back(usage_error("--status " + text + ": there is no such status", "alive, dead, removed, missing or unknown"));
    else options.status_codes[text.substr(0, text.rfind('='))] = *status;
  });
  return options;
}

/// --sheet where nothing that it is said of has sheets or layers.
void check_sheets(const std::vector<std::string>& paths, const std::vector<ReadOptions>& options, Issues& issues) {
  std::string asked, without;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (options[i].sheet.empty()) continue;
    std::error_code code;
    const bool has_none = fs::is_directory(paths[i], code) || (fs::is_regular_file(paths[i], code) && file_kind(paths[i]) == FileKind::text);
    if (!has_none) return;
    asked = options[i].sheet;
    without += (without.empty() ? "" : ", ") + paths[i];
  }
  if (!without.empty()) issues.push_back(usage_error("--sheet " + asked + ": " + without + " has no sheets", "only workbooks, GIS files and projects have some; leave it out"));
}

}  // namespace

std::vector<std::string> inventory_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const std::string base = inventory_name(path);
    std::string name = base;
    for (int n = 2; is_among(name, names); ++n) name = base + "-" + std::to_string(n);
    names.push_back(name);
  }
  return names;
}

ReadInputs read_inputs(const std::vector<std::string>& paths, const ReadOverrides& overrides, Session& session, const Progress& progress) {
  ReadInputs read;
  const std::vector<std::string> names = overrides.names.size() == paths.size() ? overrides.names : inventory_names(paths);
  const OverrideReader reader(names, read.usage);
  reader.check("--map", overrides.map, true);
  reader.check("--unit", overrides.unit, true);
  reader.check("--status", overrides.status, true);
  std::vector<ReadOptions> options;
  for (const std::string& name : names) options.push_back(options_for(name, overrides, reader, read.usage));
  check_sheets(paths, options, read.usage);
  if (has_error(read.usage)) return read;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    progress.at(static_cast<double>(i) / static_cast<double>(paths.size()), "Reading " + names[i]);
    options[i].threads = session.common.threads;
    ReadInput input{paths[i], names[i], read_inventory(paths[i], options[i])};
    if (input.inventory) input.inventory->name = names[i];
    read.inputs.push_back(std::move(input));
    progress.check();
  }
  return read;
}

}  // namespace stemwise
