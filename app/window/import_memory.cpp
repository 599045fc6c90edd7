#include "app/window/import_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/replace_file.hpp"

namespace stemwise {
namespace {

using Json = nlohmann::json;
constexpr std::size_t most_entries = 200;

bool says_nothing(const ReadOptions& o) { return o.columns.empty() && o.units.empty() && o.status_codes.empty() && !o.epsg; }

/// What of the options holds for other files too.
ReadOptions of_the_header(const ReadOptions& options) {
  ReadOptions kept;
  kept.columns = options.columns;
  kept.units = options.units;
  kept.status_codes = options.status_codes;
  kept.epsg = options.epsg;
  return kept;
}

}  // namespace

ImportMemory ImportMemory::read(const std::string& path) {
  ImportMemory memory;
  memory.path_ = path;
  std::ifstream file(path);
  if (!file) return memory;
  try {
    for (const Json& json : Json::parse(file)) {
      ReadOptions options;
      options.columns = json.at("columns").get<std::map<std::string, std::string>>();
      options.units = json.at("units").get<std::map<std::string, std::string>>();
      for (const auto& [code, word] : json.at("status_codes").items()) options.status_codes[code] = stem_status_from(word.get<std::string>()).value_or(StemStatus::unknown);
      if (json.contains("epsg")) options.epsg = json.at("epsg").get<int>();
      memory.entries_.emplace_back(json.at("header").get<std::vector<std::string>>(), std::move(options));
    }
  } catch (const Json::exception&) {
    memory.entries_.clear();
  }
  return memory;
}

std::optional<ReadOptions> ImportMemory::find(const std::vector<std::string>& header) const {
  const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.first == header; });
  return at == entries_.end() || header.empty() ? std::nullopt : std::optional(at->second);
}

void ImportMemory::remember(const std::vector<std::string>& header, const ReadOptions& options) {
  if (header.empty()) return;
  std::erase_if(entries_, [&](const Entry& e) { return e.first == header; });
  if (!says_nothing(options)) entries_.insert(entries_.begin(), {header, of_the_header(options)});
  if (entries_.size() > most_entries) entries_.resize(most_entries);
  write();
}

void ImportMemory::write() const {
  if (path_.empty()) return;
  Json all = Json::array();
  for (const auto& [header, options] : entries_) {
    Json json{{"header", header}, {"columns", options.columns}, {"units", options.units}, {"status_codes", Json::object()}};
    for (const auto& [code, status] : options.status_codes) json["status_codes"][code] = to_string(status);
    if (options.epsg) json["epsg"] = *options.epsg;
    all.push_back(std::move(json));
  }
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), error);
  write_text_file(path_, all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");  // kept as well as it can be: only a memory
}

}  // namespace stemwise
