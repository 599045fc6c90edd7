#include "app/window/input_queue.hpp"

#include <gmock/gmock.h>

#include <string>

namespace stemwise {
namespace {

using Kind = InputEvent::Kind;
using ::testing::ElementsAre;

constexpr int ctrl = 341, shift = 340, enter = 257;

// Each frame as text: "+A" a key goes down, "-A" up, "a" a letter, "(" and ")" the button at a place, "@" the mouse, "w" the wheel.
std::string text_of(const InputEvent& e) {
  const std::string at = std::to_string(static_cast<int>(e.x));
  switch (e.kind) {
    case Kind::key: return (e.down ? "+" : "-") + (e.code == ctrl ? "ctrl" : e.code == shift ? "shift" : e.code == enter ? "enter" : std::string(1, static_cast<char>(e.code)));
    case Kind::character: return std::string(1, static_cast<char>(e.code));
    case Kind::button: return (e.down ? "(" : ")") + at;
    case Kind::move: return "@" + at;
    case Kind::wheel: return "w";
  }
  return "";
}

class InputQueueTest : public ::testing::Test {
 protected:
  void key(int code, bool down) { queue_.add({.kind = Kind::key, .code = code, .down = down}); }
  void stroke(int code) { key(code, true), key(code, false); }
  void letter(char c) {  // as GLFW tells it
    key(std::toupper(c), true);
    queue_.add({.kind = Kind::character, .code = c});
    key(std::toupper(c), false);
  }
  void move(double x) { queue_.add({.kind = Kind::move, .x = x}); }
  void button(bool down, double x) { queue_.add({.kind = Kind::button, .down = down, .x = x}); }
  std::vector<std::string> frames(bool typing) {
    std::vector<std::string> all;
    while (!queue_.is_empty()) {
      std::string frame;
      for (const InputEvent& e : queue_.take(typing)) frame += (frame.empty() ? "" : " ") + text_of(e);
      all.push_back(frame);
    }
    return all;
  }
  InputQueue queue_;
};

TEST_F(InputQueueTest, AKeyStruckAndLetGoIsDownForOneFrame) {
  stroke('N');
  EXPECT_THAT(frames(false), ElementsAre("+N", "-N"));
}

TEST_F(InputQueueTest, KeysOfOneMomentKeepTheirOrder) {
  letter('n');
  letter('a');
  EXPECT_THAT(frames(false), ElementsAre("+N n", "-N +A a", "-A"));
}

TEST_F(InputQueueTest, AKeyStruckTwiceIsUpInBetween) {
  key(ctrl, true);
  stroke('Z');
  key(ctrl, false);
  key(ctrl, true);
  stroke('Z');
  EXPECT_THAT(frames(false), ElementsAre("+ctrl +Z", "-Z -ctrl", "+ctrl +Z", "-Z"));
}

TEST_F(InputQueueTest, AModifierHoldsAsLongAsItsKey) {
  key(ctrl, true);
  stroke('A');
  key(ctrl, false);
  letter('x');
  EXPECT_THAT(frames(true), ElementsAre("+ctrl +A", "-A -ctrl +X x -X"));
}

TEST_F(InputQueueTest, AModifierAloneIsSeen) {
  stroke(shift);
  EXPECT_THAT(frames(false), ElementsAre("+shift", "-shift"));
}

TEST_F(InputQueueTest, LettersForAFieldComeTogetherAndEnterAfterThem) {
  for (const char c : std::string("oak")) letter(c);
  stroke(enter);
  letter('n');
  EXPECT_THAT(frames(true), ElementsAre("+O o -O +A a -A +K k -K", "+enter", "-enter +N n -N"));
}

TEST_F(InputQueueTest, AClickHappensWhereItWasMadeAfterAFrameThatHovers) {
  move(10);
  button(true, 10);
  button(false, 10);
  move(90);
  EXPECT_THAT(frames(false), ElementsAre("@10", "(10", ")10", "@90"));
}

TEST_F(InputQueueTest, ADragEndsWhereTheButtonIsLetGo) {
  button(true, 10);
  move(70);
  button(false, 70);
  move(90);
  EXPECT_THAT(frames(false), ElementsAre("(10", "@70 )70", "@90"));
}

TEST_F(InputQueueTest, AHeldModifierIsLetGoAfterTheClick) {
  key(ctrl, true);
  button(true, 5);
  button(false, 5);
  key(ctrl, false);
  EXPECT_THAT(frames(false), ElementsAre("+ctrl (5", ")5", "-ctrl"));
}

TEST_F(InputQueueTest, TheWayOfTheMouseIsOnlyItsEnd) {
  for (double x = 0; x < 50; ++x) move(x);
  EXPECT_THAT(frames(false), ElementsAre("@49"));
}

TEST_F(InputQueueTest, TheWheelDoesNotLagBehindAHandThatMovesAsItTurns) {
  for (double x = 10; x < 13; ++x) {
    move(x);
    queue_.add({.kind = Kind::wheel, .y = 1});
  }
  button(true, 12);
  EXPECT_THAT(frames(false), ElementsAre("@10 w @11 w @12 w", "(12"));
}

TEST_F(InputQueueTest, KeysAndButtonsHandedOutAreCounted) {
  letter('n');
  move(10);
  button(true, 10);
  frames(false);
  EXPECT_EQ(queue_.count(), 3);
}

}  // namespace
}  // namespace stemwise
