#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace stemwise {

/// One thing that a command has done, for its --json.
struct ResultFact {
  std::string key;
  std::variant<std::string, std::int64_t, std::vector<std::string>> value;
};

/// One JSON object of them, in their order.
std::string result_json(const std::vector<ResultFact>& facts);

}  // namespace stemwise
