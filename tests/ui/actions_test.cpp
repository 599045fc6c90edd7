#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/project/commands.hpp"
#include "ui/actions/action.hpp"
#include "ui/actions/availability.hpp"

namespace stemwise::ui {
namespace {

TEST(Actions, EveryActionHasALabelAHelpSentenceAndAKeyOfItsOwn) {
  std::map<std::string, std::string> by_chord;
  std::set<std::string> names;
  for (const Action& a : all_actions()) {
    EXPECT_FALSE(std::string(a.label).empty()) << a.name;
    EXPECT_TRUE(std::string(a.help).ends_with(".")) << a.name;
    EXPECT_TRUE(names.insert(a.name).second) << a.name;
    const std::string chord = to_string(a.chord);
    EXPECT_FALSE(chord.empty()) << a.name;
    EXPECT_TRUE(by_chord.emplace(chord, a.name).second) << a.name << " and " << by_chord[chord] << " share " << chord;
  }
}

TEST(Actions, WhatCannotBeDoneInAnEmptyProjectSaysWhy) {
  const Project project;
  const Derived derived;
  const Availabilities available = availabilities(project, derived, ViewState{}, WindowStatus{});
  const auto why = [&](ActionId id) { return available[static_cast<std::size_t>(id)].why_not; };
  EXPECT_EQ(why(ActionId::file_open), "");
  EXPECT_EQ(why(ActionId::file_add), "");
  EXPECT_EQ(why(ActionId::file_demo), "");
  EXPECT_EQ(why(ActionId::edit_undo), "Nothing to undo");
  EXPECT_EQ(why(ActionId::align_run), "Alignment needs two inventories or more");
  EXPECT_EQ(why(ActionId::review_accept), "Select a tree first");
  EXPECT_NE(why(ActionId::export_run), "");
}

TEST(Actions, WhileAJobRunsOnlyWhatDoesNotDisturbItCanBeDone) {
  const Project project;
  WindowStatus status;
  status.jobs.push_back({.id = 1, .title = "Align", .state = JobView::State::running});
  const Availabilities available = availabilities(project, Derived{}, ViewState{}, status);
  EXPECT_TRUE(available[static_cast<std::size_t>(ActionId::align_cancel)].enabled());
  EXPECT_FALSE(available[static_cast<std::size_t>(ActionId::file_open)].enabled());
}

TEST(Actions, KeysAreWrittenAsPeopleReadThem) {
  EXPECT_EQ(to_string(action(ActionId::file_save_as).chord), "Ctrl+Shift+S");
  EXPECT_EQ(to_string(action(ActionId::view_blink).chord), "Space");
  EXPECT_EQ(to_string(action(ActionId::help_keys).chord), "?");
  EXPECT_EQ(label_with_key(ActionId::review_accept), "Accept (A)");
}

}  // namespace
}  // namespace stemwise::ui
