#pragma once

namespace stemwise {

/// The key that a person means. GLFW numbers keys by their place on an American keyboard: the one that writes Z in Germany is
/// its Y. `name`: what the key writes on its own in the person's layout (glfwGetKeyName), or null. Keys of the number pad that
/// mean the same as others become those.
int layout_key(int key, const char* name);

}  // namespace stemwise
