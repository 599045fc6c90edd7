// Debian's GLEW is built for GLX: without an X display glewInit() loads every function pointer and then answers 4
// ("no GLX display"), and VTK gives up. On an EGL surfaceless context there is no X display and none is needed, so this
// answer counts as success. Must lie in the executable itself, ahead of libGLEW in the search order: app/CMakeLists.txt and
// tests/CMakeLists.txt give it to every program that draws. Source: shared/spec/stack.md, section 3.
#include <dlfcn.h>

extern "C" unsigned int glewInit() {
  constexpr unsigned int glew_ok = 0;
  constexpr unsigned int glew_error_no_glx_display = 4;
  using Init = unsigned int (*)();
  const auto real = reinterpret_cast<Init>(dlsym(RTLD_NEXT, "glewInit"));
  if (!real) return 1;
  const unsigned int result = real();
  return result == glew_error_no_glx_display ? glew_ok : result;
}
