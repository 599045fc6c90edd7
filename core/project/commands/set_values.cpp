#include "core/project/commands.hpp"
#include "core/project/commands/whole_state.hpp"

namespace stemwise {
namespace {

/// Puts a value under a key of a map, or takes the key out; what was there before comes back on revert.
template <class Map>
class SetEntryCommand final : public Command {
 public:
  using Key = typename Map::key_type;
  using Value = typename Map::mapped_type;
  SetEntryCommand(std::string label, Map ProjectState::*map, Key key, std::optional<Value> value)
      : label_(std::move(label)), map_(map), key_(std::move(key)), value_(std::move(value)) {}
  void apply(ProjectState& state) override { exchange(state); }
  void revert(ProjectState& state) override { exchange(state); }
  std::string label() const override { return label_; }

 private:
  void exchange(ProjectState& state) {
    Map& map = state.*map_;
    std::optional<Value> old;
    if (const auto found = map.find(key_); found != map.end()) old = found->second;
    if (value_) {
      map.insert_or_assign(key_, *value_);
    } else {
      map.erase(key_);
    }
    value_ = std::move(old);
  }

  std::string label_;
  Map ProjectState::*map_;
  Key key_;
  std::optional<Value> value_;
};

template <class Map>
CommandPtr set_entry(std::string label, Map ProjectState::*map, typename Map::key_type key,
                     std::optional<typename Map::mapped_type> value) {
  return std::make_unique<SetEntryCommand<Map>>(std::move(label), map, std::move(key), std::move(value));
}

class GroupCommand final : public Command {
 public:
  GroupCommand(std::string label, std::vector<CommandPtr> commands) : label_(std::move(label)), commands_(std::move(commands)) {}
  void apply(ProjectState& state) override {
    std::size_t done = 0;
    try {
      for (; done < commands_.size(); ++done) commands_[done]->apply(state);
    } catch (...) {
      while (done > 0) commands_[--done]->revert(state);
      throw;
    }
  }
  void revert(ProjectState& state) override {
    for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) (*command)->revert(state);
  }
  std::string label() const override { return label_; }

 private:
  std::string label_;
  std::vector<CommandPtr> commands_;
};

}  // namespace

CommandPtr set_georeference(Georeference georeference) {
  return set_value("Georeference", std::move(georeference), [](ProjectState& s) -> Georeference& { return s.georeference; });
}

CommandPtr set_fusion_policy(FusionPolicy policy) {
  return set_value(std::string("Fusion policy ") + to_string(policy), policy, [](ProjectState& s) -> FusionPolicy& { return s.fusion; });
}

CommandPtr set_title(std::string title) {
  return set_value("Project title", std::move(title), [](ProjectState& s) -> std::string& { return s.title; });
}

CommandPtr set_coverage(InventoryId id, Coverage coverage) {
  return set_entry("Set coverage", &ProjectState::coverages, id, std::optional<Coverage>(std::move(coverage)));
}

CommandPtr set_dbh_error(InventoryId id, std::optional<double> error_m) {
  return set_entry("Set DBH error", &ProjectState::dbh_error_m, id, error_m);
}

CommandPtr set_setting(std::string key, std::string value) {
  std::string label = "Set " + key;
  return set_entry(std::move(label), &ProjectState::settings, std::move(key), std::optional<std::string>(std::move(value)));
}

CommandPtr group(std::string label, std::vector<CommandPtr> commands) {
  return std::make_unique<GroupCommand>(std::move(label), std::move(commands));
}

}  // namespace stemwise
