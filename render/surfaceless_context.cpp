#include "render/surfaceless_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>
#include <cstring>

namespace stemwise::render {
namespace {

using Made = Result<std::unique_ptr<SurfacelessContext>>;

Made no_context(const std::string& why) {
  return Made::failure(Issue{.text = "no picture can be drawn without a display: " + why,
                             .help = "install libgl1-mesa-dri and libegl1, or run under xvfb-run"});
}

EGLDisplay surfaceless_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get && extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless"))
    return get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

}  // namespace

Made SurfacelessContext::create() {
  const EGLDisplay display = surfaceless_display();
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return no_context("EGL cannot be started");
  std::unique_ptr<SurfacelessContext> made(new SurfacelessContext);
  made->display_ = display;
  if (!eglBindAPI(EGL_OPENGL_API)) return no_context("EGL knows no desktop OpenGL");
  constexpr std::array<EGLint, 13> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
                                          EGL_GREEN_SIZE,   8,               EGL_BLUE_SIZE,       8,              EGL_ALPHA_SIZE, 8,
                                          EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1) return no_context("no matching EGL configuration");
  constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,       3, EGL_CONTEXT_MINOR_VERSION, 2,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  made->context_ = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  if (made->context_ == EGL_NO_CONTEXT) return no_context("OpenGL 3.2 is not available");
  constexpr std::array<EGLint, 5> tiny{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
  made->surface_ = eglCreatePbufferSurface(display, config, tiny.data());
  if (!eglMakeCurrent(display, made->surface_, made->surface_, made->context_)) return no_context("the context cannot be made current");
  return made;
}

SurfacelessContext::~SurfacelessContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (surface_) eglDestroySurface(display_, surface_);
  if (context_) eglDestroyContext(display_, context_);
  // The display stays initialised: EGL shares it within the process, and another context may live on it.
}

void SurfacelessContext::make_current() { eglMakeCurrent(display_, surface_, surface_, context_); }

std::string SurfacelessContext::renderer_name() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace stemwise::render
