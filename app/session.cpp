#include "app/session.hpp"

#include "app/check_output.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "io/replace_file.hpp"

namespace stemwise {
namespace {

Issue wrong(const std::string& file, const std::string& text, const std::string& help = "") {
  return {Severity::error, file, 0, "", text, help};
}

std::string text_of(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void read_config(const std::string& path, GivenSettings& given) {
  std::ifstream in(path);
  if (!in) {
    given.issues.push_back(wrong(path, "cannot be read"));
    return;
  }
  const nlohmann::json config = nlohmann::json::parse(in, nullptr, false);
  if (!config.is_object()) {
    given.issues.push_back(wrong(path, "is not a JSON object of settings", "expected {\"key\": value, ...} with the keys that --set takes"));
    return;
  }
  for (const auto& [key, value] : config.items()) {
    if (value.is_structured()) {
      given.issues.push_back(wrong(path, "the value of '" + key + "' is not a number, a text, true or false"));
    } else {
      given.values.emplace_back(key, text_of(value));
    }
  }
}

}  // namespace

GivenSettings given_settings(const CommonOptions& common) {
  GivenSettings given;
  if (!common.config.empty()) read_config(common.config, given);
  for (const std::string& setting : common.settings) {
    const auto sign = setting.find('=');
    if (sign == std::string::npos || sign == 0) {
      given.issues.push_back(wrong("", "--set " + setting + ": expected key=value"));
    } else {
      given.values.emplace_back(setting.substr(0, sign), setting.substr(sign + 1));
    }
  }
  return given;
}

Issues as_settings(Issues issues, const std::string& prefix) {
  for (Issue& issue : issues) {
    if (issue.column.empty()) continue;
    issue.text = "setting " + prefix + issue.column + ": " + issue.text;
    issue.column.clear();
  }
  return issues;
}

ExitCode Session::apply_settings(Fields fields) {
  GivenSettings given = given_settings(common);
  for (const auto& [key, value] : given.values) {
    const Issues found = as_settings(set_field(fields, key, value));
    given.issues.insert(given.issues.end(), found.begin(), found.end());
  }
  console.issues(given.issues);
  return has_error(given.issues) ? ExitCode::usage : ExitCode::done;
}

ExitCode Session::write_json(const std::string& text) {
  if (common.json.empty()) return ExitCode::done;
  console.end_progress();
  if (const ExitCode code = check_json_target(common.json, {}, console); code != ExitCode::done) return code;  // as -o may be by now
  const Issues found = write_result(common.json, text);
  console.issues(found);
  return has_error(found) ? ExitCode::failed : ExitCode::done;
}

Issues write_result(const std::string& path, const std::string& text) {
  if (path != "-") return write_text_file(path, text).issues;
  std::cout << text << std::flush;
  return std::cout ? Issues{} : Issues{wrong("stdout", "cannot be written")};
}

}  // namespace stemwise
