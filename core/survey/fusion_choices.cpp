#include "core/survey/fusion_choices.hpp"

#include <array>
#include <charconv>

#include "core/project/commands/whole_state.hpp"

namespace stemwise {
namespace {

constexpr const char* prefix = "fusion.tree.";
constexpr std::array<const char*, 3> words{"dbh", "position", "species"};

std::string key_of(TreeId tree, FusedAttribute attribute) { return prefix + std::to_string(tree.value) + "." + to_string(attribute); }

std::optional<std::int64_t> number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string label_of(TreeId tree, FusedAttribute attribute, bool by_policy) {
  return std::string(by_policy ? "By the policy again: " : "Choose the source: ") + to_string(attribute) + " of tree " + std::to_string(tree.value);
}

}  // namespace

const char* to_string(FusedAttribute attribute) { return words[static_cast<std::size_t>(attribute)]; }

bool is_fusion_choice(const std::string& key) { return key.starts_with(prefix); }

CommandPtr choose_source(TreeId tree, FusedAttribute attribute, std::optional<InventoryId> source) {
  return whole_state(label_of(tree, attribute, !source), [key = key_of(tree, attribute), source](ProjectState& state) {
    if (source) state.settings.insert_or_assign(key, std::to_string(source->value));
    else state.settings.erase(key);
  });
}

std::map<TreeId, FusionChoice> fusion_choices(const ProjectState& state) {
  std::map<TreeId, FusionChoice> choices;
  for (auto entry = state.settings.lower_bound(prefix); entry != state.settings.end() && is_fusion_choice(entry->first); ++entry) {
    const std::string_view rest = std::string_view(entry->first).substr(std::string_view(prefix).size());
    const std::size_t point = rest.find('.');
    const auto tree = number(rest.substr(0, point)), source = number(entry->second);
    if (point == std::string_view::npos || !tree || !source) continue;
    FusionChoice& choice = choices[TreeId{*tree}];
    const std::string_view word = rest.substr(point + 1);
    if (word == words[0]) choice.dbh = InventoryId{*source};
    if (word == words[1]) choice.position = InventoryId{*source};
    if (word == words[2]) choice.species = InventoryId{*source};
  }
  return choices;
}

}  // namespace stemwise
