#include "ui/dialogs/file_browser.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "ui/dialogs/modal.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace fs = std::filesystem;
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool fits(const std::string& name, const std::vector<std::string>& suffixes) {
  if (suffixes.empty()) return true;
  const std::string suffix = lower(fs::path(name).extension().string());
  return std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end();
}

std::string size_text(std::uintmax_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  if (bytes < 1000000) return fixed(static_cast<double>(bytes) / 1e3, 1) + " kB";
  return fixed(static_cast<double>(bytes) / 1e6, 1) + " MB";
}

}  // namespace

void FileBrowser::open(FileBrowserMode mode, const std::string& folder, const std::string& home, const std::vector<std::string>& places) {
  mode_ = std::move(mode);
  name_ = mode_.name;
  open_ = is_new_ = true;
  find_places(home, places);
  accepted_ = false;
  std::error_code error;
  list(fs::is_directory(folder, error) ? folder : fs::current_path(error).string());
}

void FileBrowser::list(const std::string& folder) {
  std::error_code error;
  std::vector<Entry> entries;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  if (error) {
    problem_ = folder + " cannot be read: " + error.message();
    return;
  }
  for (; it != fs::directory_iterator(); it.increment(error)) {
    if (error) break;
    const std::string name = it->path().filename().string();
    if (name.starts_with(".")) continue;
    Entry entry{name, it->is_directory(error), false, 0};
    entry.frames = entry.folder && mode_.many && fs::exists(it->path() / "trajectory.txt", error);
    if (!entry.folder && !fits(name, mode_.suffixes)) continue;
    if (!entry.folder) entry.bytes = it->file_size(error);
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
  problem_.clear();
  folder_ = fs::weakly_canonical(folder, error).string();
  typed_ = folder_;
  entries_ = std::move(entries);
  selected_.clear();
}

std::optional<std::vector<std::string>> FileBrowser::draw(Widgets& w) {
  if (!open_) return std::nullopt;
  const Modal modal(w, mode_.title.c_str(), 820.0f, 560.0f, open_);
  if (!modal) return std::nullopt;
  if (std::exchange(is_new_, false)) w.focus.go_to(mode_.save ? "files/name" : "files/path");
  draw_path(w);
  const float height = ImGui::GetContentRegionAvail().y - w.px(mode_.save ? 92 : 50) - (problem_.empty() ? 0.0f : w.px(24));
  draw_places(w, height);
  ImGui::SameLine(0, w.px(12));
  draw_entries(w, height);
  if (!problem_.empty()) w.text(problem_, TextRole::table, Tone::warning);
  auto result = draw_buttons(w);
  if (result) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  return result;
}

void FileBrowser::draw_path(Widgets& w) {
  if (w.button("files/up", "", {.icon = icon::up, .tooltip = "The folder above"})) list(fs::path(folder_).parent_path().string());
  ImGui::SameLine();
  w.input("files/path", typed_, {.hint = "Folder or file"});
  const bool edited = ImGui::IsItemDeactivatedAfterEdit();
  std::error_code error;
  if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) {
    go_to_typed_path();
  } else if (edited && fs::is_directory(fs::path(folder_) / typed_, error)) {
    list((fs::path(folder_) / typed_).string());  // left by Tab or the mouse
  }
}

void FileBrowser::go_to_typed_path() {
  std::error_code error;
  const fs::path path = fs::path(folder_) / typed_;  // a whole path, or one from the folder that is shown
  if (fs::is_directory(path, error)) {
    list(path.string());
  } else if (mode_.save && fs::is_directory(path.parent_path(), error)) {
    list(path.parent_path().string());
    name_ = path.filename().string();
  } else if (fs::exists(path, error)) {
    list(path.parent_path().string());
    selected_ = {path.filename().string()};
    accepted_ = true;
  } else {
    problem_ = "There is no file or folder " + typed_;
  }
}

void FileBrowser::find_places(const std::string& home, const std::vector<std::string>& places) {
  places_.clear();
  std::set<fs::path> known;
  const auto add = [&](const std::string& path, const std::string& label, const char* mark) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    if (!path.empty() && known.insert(canonical.has_filename() ? canonical : canonical.parent_path()).second) places_.push_back({path, label, mark});
  };
  known.insert("/");  // is last in the list
  add(home, "Home", icon::home);
  for (const std::string& path : places) {
    const fs::path folder = fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path();
    add(path, folder.filename().string(), icon::folder);
  }
  places_.push_back({"/", "Computer", icon::folder});
}

void FileBrowser::draw_places(Widgets& w, float height) {
  ImGui::BeginChild("places", {w.px(168), height});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (const Place& place : places_) {
    const Rect row = w.next_rect(w.available_width(), w.px(28));
    if (w.area("files/place/" + place.label, row, place.path)) list(place.path);
    if (ImGui::IsItemHovered()) w.tooltip(place.path);
    w.text_in({row.x + w.px(8), row.y, w.px(18), row.height}, place.icon, TextRole::body, Tone::secondary);
    w.text_in({row.x + w.px(30), row.y, row.width - w.px(34), row.height}, place.label, TextRole::body, place.path == folder_ ? Tone::accent : Tone::text);
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

void FileBrowser::draw_entries(Widgets& w, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {w.px(4), w.px(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1.0f);
  ImGui::BeginChild("entries", {0, height}, true);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  if (entries_.empty()) w.text("Nothing here that can be read.", TextRole::body, Tone::secondary);
  const std::string folder_before = folder_;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()), w.px(26));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd && folder_ == folder_before; ++i) {
      draw_entry(w, Entry(entries_[static_cast<std::size_t>(i)]), static_cast<std::size_t>(i));
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
}

void FileBrowser::draw_entry(Widgets& w, const Entry& entry, std::size_t row_index) {
  const Rect row = w.next_rect(w.available_width(), w.px(26));
  const bool selected = selected_.contains(entry.name);
  if (selected) w.fill(row, w.tokens().accent_soft, w.px(4));
  ImGui::PushID(static_cast<int>(row_index));
  const bool pressed = w.area("files/entry/" + entry.name, row, entry.folder ? "folder" : "file");
  const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
  ImGui::PopID();
  w.text_in({row.x + w.px(8), row.y, w.px(20), row.height}, entry.frames ? icon::tree : entry.folder ? icon::folder : icon::file, TextRole::body,
            entry.folder ? Tone::accent : Tone::secondary);
  w.text_in({row.x + w.px(32), row.y, row.width - w.px(150), row.height}, entry.name, TextRole::body, Tone::text);
  const std::string right = entry.frames ? "frame folder" : entry.folder ? "" : size_text(entry.bytes);
  w.text_in({row.right() - w.px(112), row.y, w.px(104), row.height}, right, TextRole::table, Tone::secondary, Align::right);
  if (twice) {
    if (entry.folder) {
      list((fs::path(folder_) / entry.name).string());
    } else {
      choose(entry, false);
      accepted_ = true;
    }
  } else if (pressed) {
    choose(entry, ImGui::GetIO().KeyCtrl);
  }
}

void FileBrowser::choose(const Entry& entry, bool add) {
  const bool was = selected_.contains(entry.name);
  if (!add || !mode_.many) selected_.clear();
  if (add && was) {
    selected_.erase(entry.name);
  } else {
    selected_.insert(entry.name);
  }
  if (mode_.save && !entry.folder) name_ = entry.name;
}

/// As it will be written: a name without a suffix that fits gets the first one.
std::string FileBrowser::file_name() const {
  const std::string suffix = fs::path(name_).extension().string();
  const bool fits = mode_.suffixes.empty() || std::find(mode_.suffixes.begin(), mode_.suffixes.end(), suffix) != mode_.suffixes.end();
  return name_.empty() || fits ? name_ : name_ + mode_.suffixes.front();
}

std::vector<std::string> FileBrowser::chosen() const {
  if (mode_.save) return {(fs::path(folder_) / file_name()).string()};
  std::vector<std::string> paths;
  for (const std::string& name : selected_) paths.push_back((fs::path(folder_) / name).string());
  return paths;
}

std::string FileBrowser::why_not() const {
  if (mode_.save) return name_.empty() ? "Give a file name" : "";
  if (selected_.empty()) return mode_.many ? "Select files or frame folders (Ctrl+click for several)" : "Select a file";
  return "";
}

std::optional<std::vector<std::string>> FileBrowser::draw_buttons(Widgets& w) {
  std::error_code error;
  if (mode_.save) {
    w.input("files/name", name_, {.hint = "File name"});
    if (ImGui::IsItemDeactivated() && !name_.empty() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) accepted_ = true;
    const bool there = !name_.empty() && fs::exists(fs::path(folder_) / file_name(), error);
    const std::string words = there ? file_name() + " is there already" : file_name() == name_ ? "" : "as " + file_name();
    w.text(words, TextRole::caption, there ? Tone::warning : Tone::secondary);
    w.record_last("files/as", words);
    ImGui::SameLine();
  }
  const float width = w.px(132);
  const float y = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - w.px(46);
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - w.px(20);
  if (w.button_in({right - 2 * width - w.px(8), y, width, w.px(30)}, "files/cancel", "Cancel")) open_ = false;
  const bool pressed = w.button_in({right - width, y, width, w.px(30)}, "files/accept", mode_.accept, {.primary = true, .why_not = why_not()});
  if (!pressed && !accepted_) return std::nullopt;
  accepted_ = false;
  // One plain folder: going into it is what was meant.
  if (!mode_.save && selected_.size() == 1) {
    const fs::path only = fs::path(folder_) / *selected_.begin();
    if (fs::is_directory(only, error) && !(mode_.many && fs::exists(only / "trajectory.txt", error))) {
      list(only.string());
      return std::nullopt;
    }
  }
  return chosen();
}

}  // namespace stemwise::ui
