#pragma once
#include <memory>
#include <string>

#include "core/base/result.hpp"

namespace stemwise::render {

/// A GL 3.2 core context without display, X server or window (EGL surfaceless), current on this thread while it lives.
/// The program must contain app/glew_without_glx.cpp, else VTK refuses it.
class SurfacelessContext {
 public:
  /// An issue with the reason where the platform has none (no EGL, no driver).
  static Result<std::unique_ptr<SurfacelessContext>> create();
  ~SurfacelessContext();
  SurfacelessContext(const SurfacelessContext&) = delete;
  SurfacelessContext& operator=(const SurfacelessContext&) = delete;

  void make_current();
  std::string renderer_name() const;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"

 private:
  SurfacelessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
};

}  // namespace stemwise::render
