#include "app/window/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>

namespace stemwise {
namespace {

using Kind = InputEvent::Kind;

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

/// What one frame has taken so far, and so what may join it.
class Share {
 public:
  explicit Share(bool typing) : typing_(typing) {}

  bool fits(const InputEvent& e, bool is_letter) const {
    switch (state_) {
      case State::open: return e.kind == Kind::key ? !(e.down ? let_go_ : modifiers_).contains(e.code) : !(e.kind == Kind::button && e.down && moved_);
      case State::letters: return e.kind == Kind::character || (e.kind == Kind::key && !is_modifier(e.code) && (!e.down || (typing_ && is_letter)));
      case State::struck: return e.kind == Kind::character;
      case State::clicked: return false;
      case State::turned: return e.kind == Kind::wheel || e.kind == Kind::move;  // a hand that turns it moves too: waiting would only lag
    }
    return false;
  }

  void take(const InputEvent& e, bool is_letter) {
    if (e.kind == Kind::move) moved_ = true;
    if (e.kind == Kind::button) state_ = State::clicked;
    if (e.kind == Kind::wheel) state_ = State::turned;
    if (e.kind == Kind::character && state_ == State::open) state_ = State::letters;
    if (e.kind != Kind::key) return;
    if (!e.down) {
      let_go_.insert(e.code);
    } else if (is_modifier(e.code)) {
      modifiers_.insert(e.code);
    } else {
      state_ = typing_ && is_letter ? State::letters : State::struck;
    }
  }

 private:
  enum class State { open, letters, struck, clicked, turned };
  bool typing_;
  State state_ = State::open;
  bool moved_ = false;       ///< what lies over something else has to be hovered for a frame before it can be clicked
  std::set<int> modifiers_;  ///< pressed in this frame: Alt alone means something too
  std::set<int> let_go_;     ///< in this frame: pressed again within it they would never have been up
};

}  // namespace

void InputQueue::add(const InputEvent& event) {
  if (event.kind == Kind::move && !waiting_.empty() && waiting_.back().kind == Kind::move) {
    waiting_.back() = event;
  } else {
    waiting_.push_back(event);
  }
}

std::vector<InputEvent> InputQueue::take(bool typing) {
  std::vector<InputEvent> taken;
  Share share(typing);
  while (!waiting_.empty()) {
    const InputEvent event = waiting_.front();
    const bool is_letter = waiting_.size() > 1 && waiting_[1].kind == Kind::character;  // GLFW tells it right after its key
    if (!share.fits(event, is_letter)) break;
    share.take(event, is_letter);
    waiting_.pop_front();
    if (event.kind == Kind::key || event.kind == Kind::button) ++count_;
    taken.push_back(event);
  }
  return taken;
}

}  // namespace stemwise
