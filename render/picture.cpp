#include "render/picture.hpp"

#include <cairo.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace stemwise::render {
namespace {

/// cairo's premultiplied ARGB words.
std::vector<std::uint32_t> premultiplied(const Image& image) {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(image.size.width) * image.size.height);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint8_t* p = image.rgba.data() + 4 * i;
    const auto times = [&](std::uint32_t c) { return (c * p[3] + 127) / 255; };
    words[i] = static_cast<std::uint32_t>(p[3]) << 24 | times(p[0]) << 16 | times(p[1]) << 8 | times(p[2]);
  }
  return words;
}

cairo_status_t append(void* target, const unsigned char* data, unsigned int length) {
  auto* bytes = static_cast<std::vector<std::uint8_t>*>(target);
  bytes->insert(bytes->end(), data, data + length);
  return CAIRO_STATUS_SUCCESS;
}

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

Result<Done> not_written(const std::string& path, const std::string& why) {
  return Result<Done>::failure(Issue{.file = path, .text = "the picture cannot be written: " + why, .help = "choose another folder or file name"});
}

}  // namespace

std::vector<std::uint8_t> png_bytes(const Image& image) {
  std::vector<std::uint32_t> words = premultiplied(image);
  const cairo_format_t format = is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32;
  cairo_surface_t* surface = cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(words.data()), format, image.size.width,
                                                                 image.size.height, 4 * image.size.width);
  std::vector<std::uint8_t> bytes;
  cairo_surface_write_to_png_stream(surface, append, &bytes);
  cairo_surface_destroy(surface);
  return bytes;
}

Result<Done> write_bytes(const std::vector<std::uint8_t>& bytes, const std::string& path) {
  const std::string beside = path + ".part";
  {
    std::ofstream out(beside, std::ios::binary);
    if (!out) return not_written(path, std::strerror(errno));
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) {
      std::remove(beside.c_str());
      return not_written(path, "the disk is full or read-only");
    }
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (!error) return Done{};
  std::remove(beside.c_str());
  return not_written(path, error.message());
}

Result<Done> write_png(const Image& image, const std::string& path) { return write_bytes(png_bytes(image), path); }

Result<Image> read_png(const std::string& path) {
  cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy(surface);
    return Result<Image>::failure(Issue{.file = path, .text = "this is no PNG picture that can be read"});
  }
  Image image;
  image.size = {cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface)};
  image.rgba.resize(static_cast<std::size_t>(4) * image.size.width * image.size.height);
  const bool has_alpha = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_ARGB32;
  const unsigned char* data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      std::uint32_t word;
      std::memcpy(&word, data + static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface)) * y + 4 * x, 4);
      const std::uint32_t alpha = has_alpha ? word >> 24 : 255;
      std::uint8_t* p = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * image.size.width + x);
      const auto straight = [alpha](std::uint32_t c) { return static_cast<std::uint8_t>(alpha == 0 ? 0 : std::min<std::uint32_t>(255, (c * 255 + alpha / 2) / alpha)); };
      p[0] = straight(word >> 16 & 255);
      p[1] = straight(word >> 8 & 255);
      p[2] = straight(word & 255);
      p[3] = static_cast<std::uint8_t>(alpha);
    }
  cairo_surface_destroy(surface);
  return image;
}

}  // namespace stemwise::render
