#pragma once
#include <cstdint>
#include <deque>
#include <vector>

namespace stemwise {

/// One thing done with keyboard or mouse; codes are GLFW's.
struct InputEvent {
  enum class Kind { key, character, button, move, wheel };
  Kind kind = Kind::key;
  int code = 0;             ///< the key, the mouse button or the character
  bool down = false;        ///< of key and button: pressed, else let go
  int scancode = 0;
  double x = 0.0, y = 0.0;  ///< button and move: the place in window px; wheel: notches
};

/// What a person did, in order, until a frame has room for it. Dear ImGui 1.86 looks at keyboard and mouse once a frame: a
/// key struck and let go in between was never down, a click happens where the mouse has gone since, and of two keys it
/// knows no order. So a frame gets what has only one meaning within it, and the rest waits for the frames after.
class InputQueue {
 public:
  void add(const InputEvent& event);
  bool is_empty() const { return waiting_.empty(); }
  /// The next frame's share. `typing`: a text field has the keyboard; letters for it may come together.
  std::vector<InputEvent> take(bool typing);
  /// Keys and buttons handed out so far, down and up each: scripts wait for it.
  std::int64_t count() const { return count_; }

 private:
  std::deque<InputEvent> waiting_;
  std::int64_t count_ = 0;
};

}  // namespace stemwise
