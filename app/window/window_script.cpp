#include "app/window/window_script.hpp"

#include <cctype>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/window/headless_window.hpp"
#include "app/window/window_model.hpp"

namespace stemwise {
namespace {

const ui::Action* action_named(const std::string& name) {
  for (const ui::Action& a : ui::all_actions()) {
    if (name == a.name) return &a;
  }
  return nullptr;
}

/// "Enter", "Escape", "Space", or a letter or digit.
ui::KeyChord chord_named(const std::string& name) {
  if (name == "Enter") return {ui::Key::enter};
  if (name == "Escape") return {ui::Key::escape};
  if (name == "Space") return {ui::Key::space};
  return {ui::key(static_cast<char>(std::toupper(static_cast<unsigned char>(name.empty() ? ' ' : name.front()))))};
}

/// The folder that the first line names, where a window keeps what it remembers and what it saves by itself; "" for none.
std::string config_of(std::ifstream& file) {
  std::string verb, folder;
  const auto start = file.tellg();
  if (file >> verb && verb == "config" && std::getline(file >> std::ws, folder)) return folder;
  file.clear();
  file.seekg(start);
  return "";
}

bool write_widgets(const std::string& path, HeadlessWindow& window) {
  std::ofstream file(path);
  file << registry_json(window.desk().registry()) << "\n";
  return static_cast<bool>(file.flush());
}

/// One line; false when it cannot be done.
bool run_line(HeadlessWindow& window, std::istringstream line) {
  std::string verb, word;
  line >> verb;
  const auto rest = [&line] {
    std::string text;
    std::getline(line >> std::ws, text);
    return text;
  };
  if (verb.empty() || verb.front() == '#') return true;
  if (verb == "settle") return window.settle(), true;
  if (verb == "click") return window.click(rest());
  if (verb == "double-click") return window.double_click(rest());
  if (verb == "type") return window.type(rest()), true;
  if (verb == "key") return window.press(chord_named(rest())), true;
  if (verb == "screenshot") return static_cast<bool>(window.screenshot(rest()));
  if (verb == "widgets") return write_widgets(rest(), window);
  if (verb == "fill") return line >> word, window.fill(word, rest());
  if (verb == "do") {
    const ui::Action* action = action_named(rest());
    if (action != nullptr) window.press(action->id);
    return action != nullptr;
  }
  float x = 0, y = 0;
  if (verb == "theme") {
    window.desk().model().view.theme = rest() == "dark" ? ui::ThemeName::dark : ui::ThemeName::light;
    return window.frames(3), true;
  }
  if (verb == "wait") {  // what fades after some seconds has faded; nobody sleeps
    if (!(line >> x)) return false;
    window.desk().model().notices.advance(x);
    return window.frames(2), true;
  }
  if (!(line >> x >> y)) return false;
  if (verb == "size") return window.resize(static_cast<int>(x), static_cast<int>(y)), true;
  if (verb == "move") return window.move_to(x, y), window.frames(2), true;
  if (verb == "drag") {
    float to_x = 0, to_y = 0;
    if (!(line >> to_x >> to_y)) return false;
    return window.drag(x, y, to_x, to_y), true;
  }
  if (verb == "wheel") {  // X Y NOTCHES
    float notches = 0;
    if (!(line >> notches)) return false;
    return window.move_to(x, y), window.wheel(notches), window.frames(2), true;
  }
  if (verb == "click-at") return window.click_at(x, y), true;
  return false;
}

}  // namespace

int run_window_script(const WindowOptions& options) {
  std::ifstream file(options.script);
  if (!file) {
    std::cerr << "error: " << options.script << " cannot be read\n";
    return 1;
  }
  HeadlessOptions headless;
  headless.desk.paths = options.paths;
  headless.desk.config_folder = config_of(file);
  if (options.width > 0) headless.width = options.width;
  if (options.height > 0) headless.height = options.height;
  auto window = HeadlessWindow::create(headless);
  if (!window) {
    for (const Issue& issue : window.issues) std::cerr << "error: " << to_string(issue) << "\n";
    return 1;
  }
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (run_line(**window, std::istringstream(line))) continue;
    std::cerr << "error: " << options.script << ", line " << number << ": cannot be done: " << line << "\n";
    return 1;
  }
  return 0;
}

}  // namespace stemwise
