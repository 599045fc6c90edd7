#include "render/gl/program.hpp"

#include <stdexcept>
#include <string>

namespace stemwise::render {
namespace {

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint is_good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
  if (is_good) return shader;
  char log[2048] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw std::runtime_error(std::string("shader: ") + log);
}

}  // namespace

Program::Program(const char* vertex_source, const char* fragment_source, const std::vector<const char*>& attributes) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
  id_ = glCreateProgram();
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  for (std::size_t i = 0; i < attributes.size(); ++i) glBindAttribLocation(id_, static_cast<GLuint>(i), attributes[i]);
  glBindFragDataLocation(id_, 0, "colour_out");
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint is_good = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &is_good);
  if (is_good) return;
  char log[2048] = "";
  glGetProgramInfoLog(id_, sizeof log, nullptr, log);
  throw std::runtime_error(std::string("program: ") + log);
}

Program::~Program() { glDeleteProgram(id_); }

}  // namespace stemwise::render
