#pragma once
#include <memory>
#include <span>
#include <vector>

#include "app/window/frame_damage.hpp"
#include "app/window/gl_target.hpp"

struct ImDrawData;

namespace stemwise {

/// The window's picture, kept from frame to frame: only what changed is drawn again. Where the processor draws, a still
/// window costs next to nothing and a turning forest no more than its own part of it. Needs the GL context for its whole life.
class RetainedFrame {
 public:
  /// Opaque live pictures in their own size are copied in place of being drawn, and what they hide is left out.
  /// True where something changed.
  bool draw(ImDrawData& data, int width, int height, LiveTextures live);
  void forget() { damage_.forget(); }  ///< fonts or the context are others: everything is drawn again
  /// Onto the window (framebuffer 0).
  void present() const;
  render::Image read() const;  ///< top row first
  /// Share of the window that was drawn last time, 0..1.
  double drawn_share() const { return drawn_share_; }

 private:
  /// A command that does nothing but show a whole live picture in its own size.
  struct Cover {
    ImDrawCmd* command;
    ScreenRect rect;  ///< of what it covers
  };
  void draw_rect(ImDrawData& data, const ScreenRect& rect, std::span<const Cover> covers) const;
  std::vector<Cover> find_covers(ImDrawData& data, LiveTextures live) const;

  FrameDamage damage_;
  std::unique_ptr<GlTarget> target_;
  int width_ = 0, height_ = 0;
  double drawn_share_ = 1.0;
};

}  // namespace stemwise
