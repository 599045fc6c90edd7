#include "render/gl/quads.hpp"

#include <cstdint>
#include <utility>

namespace stemwise::render {

Quads::Quads(std::size_t stride, std::vector<Attribute> attributes) : stride_(stride), attributes_(std::move(attributes)) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
}

Quads::~Quads() {
  glDeleteBuffers(1, &indices_);
  glDeleteBuffers(1, &vertices_);
  glDeleteVertexArrays(1, &array_);
}

void Quads::upload(const void* vertices, std::size_t quads) {
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * quads * stride_), vertices, GL_STATIC_DRAW);
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    const Attribute& a = attributes_[i];
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    glVertexAttribPointer(static_cast<GLuint>(i), a.components, a.type, a.is_normalised, static_cast<GLsizei>(stride_),
                          reinterpret_cast<const void*>(a.offset));
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  if (quads > indexed_) {
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * quads);
    for (std::size_t q = 0; q < quads; ++q)
      for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(static_cast<std::uint32_t>(4 * q) + corner);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(), GL_STATIC_DRAW);
    indexed_ = quads;
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  quads_ = quads;
}

void Quads::draw(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_INT, reinterpret_cast<const void*>(6 * first * sizeof(std::uint32_t)));
  glBindVertexArray(0);
}

}  // namespace stemwise::render
