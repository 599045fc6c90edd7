#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "core/project/project.hpp"
#include "io/project_stamp.hpp"
#include "ui/derived.hpp"

namespace stemwise {

/// The open project with its file and the tables derived from it. Everything that changes it goes through `execute`.
class Document {
 public:
  Document();

  const Project& project() const { return *project_; }
  const ProjectState& state() const { return project_->state(); }
  /// The state as it is now, for jobs: copied once per revision, shared by all of them.
  std::shared_ptr<const ProjectState> snapshot();
  /// Unique over all projects of this window: goes up with every change, also when another project is opened.
  std::uint64_t revision() const { return (epoch_ << 32) + project_->revision(); }
  const ui::Derived& derived() const { return *derived_; }
  std::shared_ptr<const ui::Derived> shared_derived() const { return derived_; }
  void take(std::shared_ptr<const ui::Derived> derived);  ///< dropped when older than what is there
  bool is_derived() const { return derived_->revision == revision(); }

  void execute(CommandPtr command) { project_->execute(std::move(command)); }
  void undo() { project_->undo(); }
  void redo() { project_->redo(); }
  void mark_saved(std::uint64_t revision);  ///< only when nothing was changed since that revision was written

  /// A revision of the project that is open now, not of one before it.
  bool is_of_this_project(std::uint64_t some_revision) const { return some_revision >> 32 == epoch_; }

  /// Another project takes this one's place. What it leaves behind: letting go of that takes as long as a frame, better not while drawing.
  std::shared_ptr<const void> replace(ProjectState state, std::string path, ProjectStamp stamp, bool saved);
  bool is_dirty() const { return never_saved_ || project_->is_dirty(); }
  bool is_empty() const { return state().inventories.empty(); }

  const std::string& path() const { return path_; }
  /// What the file held when it was read or written here last; nothing while there is no file.
  const ProjectStamp& stamp() const { return stamp_; }
  void set_path(std::string path, ProjectStamp stamp = {}) {
    path_ = std::move(path);
    stamp_ = std::move(stamp);
  }
  std::string title() const;  ///< the project's title, else its file's name

 private:
  std::unique_ptr<Project> project_;
  std::shared_ptr<const ui::Derived> derived_;
  std::shared_ptr<const ProjectState> snapshot_;
  std::uint64_t snapshot_revision_ = 0;
  std::uint64_t epoch_ = 1;
  std::string path_;
  ProjectStamp stamp_;
  bool never_saved_ = false;  ///< recovered, or the demo: is in no file of the person's
};

}  // namespace stemwise
