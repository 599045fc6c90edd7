#include "app/window/layout_key.hpp"

#include <GLFW/glfw3.h>

namespace stemwise {

int layout_key(int key, const char* name) {
  if (key == GLFW_KEY_KP_ADD) return GLFW_KEY_EQUAL;
  if (key == GLFW_KEY_KP_SUBTRACT) return GLFW_KEY_MINUS;
  if (key == GLFW_KEY_KP_ENTER) return GLFW_KEY_ENTER;
  if (key > GLFW_KEY_GRAVE_ACCENT || name == nullptr || name[0] == 0 || name[1] != 0) return key;
  const char c = name[0];
  if (c >= 'a' && c <= 'z') return c - 'a' + 'A';
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return key;  // a French keyboard writes digits with Shift
  if (c == '+' || c == '=') return GLFW_KEY_EQUAL;
  if (c == '-') return GLFW_KEY_MINUS;
  return key;
}

}  // namespace stemwise
