#include "app/window/retained_frame.hpp"

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>

namespace stemwise {
namespace {

/// What `copy_picture` has to know; lies in the list of covers while a frame is drawn.
struct Copy {
  GLuint texture = 0;
  ScreenRect rect;  ///< of the whole picture in the window
  int window_height = 0;
};

ScreenRect clip_of(const ImDrawCmd& command) {
  return {static_cast<int>(command.ClipRect.x), static_cast<int>(command.ClipRect.y), static_cast<int>(command.ClipRect.z), static_cast<int>(command.ClipRect.w)};
}

/// ImGui's callback in place of a draw: a plain copy, much cheaper than sampling where the processor draws.
void copy_picture(const ImDrawList*, const ImDrawCmd* command) {
  const auto& copy = *static_cast<const Copy*>(command->UserCallbackData);
  const ScreenRect part = intersection(clip_of(*command), copy.rect);
  if (part.is_empty()) return;
  GLuint framebuffer = 0;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, copy.texture, 0);
  const int left = part.left - copy.rect.left, right = part.right - copy.rect.left;
  const int low = copy.rect.bottom - part.bottom, high = copy.rect.bottom - part.top;
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(left, low, right, high, part.left, copy.window_height - part.bottom, part.right, copy.window_height - part.top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
  glDeleteFramebuffers(1, &framebuffer);
}

bool is_whole(float value) { return value == std::floor(value); }

/// The rectangle in which a command shows the whole picture, upright and in its own size; empty for any other command.
ScreenRect picture_rect(const ImDrawList& list, const ImDrawCmd& command, const LiveTexture& live) {
  if (command.ElemCount != 6) return {};
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
  const ImDrawVert &a = vertices[indices[0]], &c = vertices[indices[2]];  // upper left and lower right
  const bool is_exact = is_whole(a.pos.x) && is_whole(a.pos.y) && c.pos.x - a.pos.x == static_cast<float>(live.width_px) && c.pos.y - a.pos.y == static_cast<float>(live.height_px);
  const bool is_all = a.uv.x == 0.0F && a.uv.y == 1.0F && c.uv.x == 1.0F && c.uv.y == 0.0F && a.col == IM_COL32_WHITE;
  if (!is_exact || !is_all) return {};
  return {static_cast<int>(a.pos.x), static_cast<int>(a.pos.y), static_cast<int>(c.pos.x), static_cast<int>(c.pos.y)};
}

/// `rect` in parts of which one lies in `inner` and the others beside it.
void split(const ScreenRect& rect, const ScreenRect& inner, std::vector<ScreenRect>& parts) {
  const ScreenRect both = intersection(rect, inner);
  if (both.is_empty()) {
    parts.push_back(rect);
    return;
  }
  for (const ScreenRect& part : {both, ScreenRect{rect.left, rect.top, rect.right, both.top}, ScreenRect{rect.left, both.bottom, rect.right, rect.bottom},
                                 ScreenRect{rect.left, both.top, both.left, both.bottom}, ScreenRect{both.right, both.top, rect.right, both.bottom}})
    if (!part.is_empty()) parts.push_back(part);
}

bool contains(const ScreenRect& outer, const ScreenRect& inner) { return intersection(outer, inner) == inner; }

}  // namespace

std::vector<RetainedFrame::Cover> RetainedFrame::find_covers(ImDrawData& data, LiveTextures live) const {
  std::vector<Cover> covers;
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer)
      for (const LiveTexture& one : live) {
        if (!one.is_opaque_picture || reinterpret_cast<std::uintptr_t>(command.TextureId) != one.texture) continue;
        const ScreenRect rect = picture_rect(*data.CmdLists[i], command, one);
        if (!rect.is_empty()) covers.push_back({&command, rect});
      }
  return covers;
}

bool RetainedFrame::draw(ImDrawData& data, int width, int height, LiveTextures live) {
  if (!target_ || width != width_ || height != height_) {
    target_ = std::make_unique<GlTarget>(width, height);
    forget();
  }
  width_ = width;
  height_ = height;
  if (data.FramebufferScale.x != 1.0F || data.FramebufferScale.y != 1.0F) forget();
  const std::vector<ScreenRect> rects = damage_.update(data, width, height, live);
  std::vector<Cover> covers = find_covers(data, live);
  std::vector<Copy> copies;
  for (const Cover& cover : covers) copies.push_back({static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(cover.command->TextureId)), cover.rect, height});
  for (std::size_t i = 0; i < covers.size(); ++i) {
    covers[i].command->UserCallback = copy_picture;
    covers[i].command->UserCallbackData = &copies[i];
    covers[i].rect = intersection(covers[i].rect, clip_of(*covers[i].command));
  }
  std::vector<ScreenRect> parts;
  for (const ScreenRect& rect : rects) {
    if (covers.empty()) parts.push_back(rect);
    if (!covers.empty()) split(rect, covers.front().rect, parts);
  }
  target_->bind();
  double drawn = 0.0;
  for (const ScreenRect& part : parts) {
    draw_rect(data, part, covers);
    drawn += static_cast<double>(part.right - part.left) * (part.bottom - part.top);
  }
  drawn_share_ = drawn / (static_cast<double>(width) * height);
  for (const Cover& cover : covers) cover.command->UserCallback = nullptr;
  return !rects.empty();
}

void RetainedFrame::draw_rect(ImDrawData& data, const ScreenRect& rect, std::span<const Cover> covers) const {
  const ImDrawCmd* first = nullptr;  // what comes before it is hidden
  for (const Cover& cover : covers)
    if (contains(cover.rect, rect)) first = cover.command;
  bool is_hidden = first != nullptr;
  std::vector<ImVec4> clips;
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
      clips.push_back(command.ClipRect);
      if (&command == first) is_hidden = false;
      const ScreenRect clip = intersection(clip_of(command), rect);
      command.ClipRect = is_hidden || clip.is_empty() ? ImVec4(0, 0, 0, 0) : ImVec4(static_cast<float>(clip.left), static_cast<float>(clip.top), static_cast<float>(clip.right), static_cast<float>(clip.bottom));
    }
  if (first == nullptr) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.left, height_ - rect.bottom, rect.right - rect.left, rect.bottom - rect.top);
    glClearColor(0.95F, 0.96F, 0.95F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
  }
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  std::size_t next = 0;
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) command.ClipRect = clips[next++];
}

void RetainedFrame::present() const {
  if (!target_) return;
  target_->bind_to_read();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

render::Image RetainedFrame::read() const { return target_ ? target_->read() : render::Image{}; }

}  // namespace stemwise
