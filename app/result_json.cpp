#include "app/result_json.hpp"

#include <nlohmann/json.hpp>

namespace stemwise {

std::string result_json(const std::vector<ResultFact>& facts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const ResultFact& fact : facts) std::visit([&](const auto& value) { json[fact.key] = value; }, fact.value);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace stemwise
