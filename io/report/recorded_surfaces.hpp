#pragma once
#include <cairo.h>

#include <memory>
#include <vector>

#include "io/report/recorded_pages.hpp"

namespace stemwise {

struct SurfaceDeleter {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
struct ContextDeleter {
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

struct RecordedPages::Impl {
  std::vector<Surface> surfaces;
};

}  // namespace stemwise
