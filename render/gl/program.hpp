#pragma once
#include <GL/glew.h>

#include <vector>

namespace stemwise::render {

/// A linked GLSL 1.50 program. Throws std::runtime_error with the compiler's words: our own shaders are a programmer's matter.
class Program {
 public:
  Program(const char* vertex_source, const char* fragment_source, const std::vector<const char*>& attributes);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const { glUseProgram(id_); }
  GLint at(const char* uniform) const { return glGetUniformLocation(id_, uniform); }

 private:
  GLuint id_ = 0;
};

}  // namespace stemwise::render
