#pragma once
#include <GL/glew.h>

#include <cstddef>
#include <vector>

namespace stemwise::render {

/// One vertex attribute inside a vertex struct.
struct Attribute {
  GLint components = 0;
  GLenum type = GL_FLOAT;
  GLboolean is_normalised = GL_FALSE;
  std::size_t offset = 0;
};

/// Many small quads in one static buffer, four vertices each. Software renderers pay dearly for instances and nothing for
/// repeated vertices, so each item stands there four times and the shader spreads it by gl_VertexID.
class Quads {
 public:
  Quads(std::size_t stride, std::vector<Attribute> attributes);
  ~Quads();
  Quads(const Quads&) = delete;
  Quads& operator=(const Quads&) = delete;

  /// `vertices`: 4 per quad, in the order of corners (0 left low, 1 right low, 2 right high, 3 left high).
  void upload(const void* vertices, std::size_t quads);
  void draw() const { draw(0, quads_); }
  void draw(std::size_t first, std::size_t count) const;
  std::size_t size() const { return quads_; }

 private:
  std::size_t stride_;
  std::vector<Attribute> attributes_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
  std::size_t quads_ = 0, indexed_ = 0;
};

}  // namespace stemwise::render
