#include "app/window/document.hpp"

#include <filesystem>

namespace stemwise {

Document::Document() : project_(std::make_unique<Project>()) { derived_ = std::make_shared<const ui::Derived>(ui::derive(state(), revision())); }

std::shared_ptr<const ProjectState> Document::snapshot() {
  if (!snapshot_ || snapshot_revision_ != revision()) {
    snapshot_ = std::make_shared<const ProjectState>(state());
    snapshot_revision_ = revision();
  }
  return snapshot_;
}

void Document::take(std::shared_ptr<const ui::Derived> derived) {
  if (derived->revision >= derived_->revision && derived->revision <= revision()) derived_ = std::move(derived);
}

void Document::mark_saved(std::uint64_t saved_revision) {
  if (saved_revision != revision()) return;
  project_->mark_saved();
  never_saved_ = false;
}

std::shared_ptr<const void> Document::replace(ProjectState state, std::string path, ProjectStamp stamp, bool saved) {
  struct Left {
    std::unique_ptr<Project> project;
    std::shared_ptr<const ui::Derived> derived;
    std::shared_ptr<const ProjectState> snapshot;
  };
  auto left = std::make_shared<const Left>(Left{std::move(project_), derived_, std::move(snapshot_)});
  project_ = std::make_unique<Project>(std::move(state));
  ++epoch_;
  set_path(std::move(path), std::move(stamp));
  never_saved_ = !saved;
  // Tables of the earlier project would name trees that are not here.
  auto empty = std::make_shared<ui::Derived>();
  empty->revision = epoch_ << 32;
  if (!is_empty()) empty->revision -= 1;
  derived_ = std::move(empty);
  return left;
}

std::string Document::title() const {
  if (!state().title.empty()) return state().title;
  return path_.empty() ? "Untitled" : std::filesystem::path(path_).stem().string();
}

}  // namespace stemwise
