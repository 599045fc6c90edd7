#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stemwise {

/// An entry of a cache folder, open. Its parts are read one after the other; what was read counts only when `is_whole` says so
/// afterwards.
class CacheReader {
 public:
  CacheReader(int file, std::vector<std::uint64_t> part_sizes, std::uint64_t expected_sum, std::uint64_t sum_so_far);
  CacheReader(CacheReader&& other) noexcept;
  CacheReader& operator=(CacheReader&&) = delete;
  ~CacheReader();

  std::size_t parts() const { return sizes_.size(); }
  std::uint64_t size_of(std::size_t part) const { return sizes_[part]; }
  /// Fills `into`, which must be as large as the next part. False when it cannot be read.
  bool read_next(std::span<std::byte> into);
  /// All parts were read and are, byte for byte, what was written.
  bool is_whole() const;

 private:
  int file_;
  std::vector<std::uint64_t> sizes_;
  std::uint64_t expected_, sum_;
  std::size_t next_ = 0;
};

/// A folder of things that can be made again at any time: whoever deletes it loses time and nothing else. An entry has a key,
/// which is stored with it and compared byte by byte. It is written beside its place and renamed, so that a reader sees all
/// of it or nothing, and its sum is checked when it is read, so that a torn one (a crash before the disk had it) is no entry.
/// The folder holds no more than `most_bytes`: what was not used for longest goes first. Nothing here is an error for the
/// person: a folder that cannot be written is a cache that never has anything.
class CacheFolder {
 public:
  CacheFolder(std::string folder, std::uint64_t most_bytes) : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// The entry of this kind and key, marked as used now.
  std::optional<CacheReader> find(std::string_view kind, std::string_view key) const;
  /// Replaces it. False when it was not written: no such folder can be made, no room, or larger than all may be.
  bool keep(std::string_view kind, std::string_view key, std::span<const std::span<const std::byte>> parts) const;
  /// Where an entry lies; "triangles-0123456789abcdef.stemwise-cache".
  std::string path_of(std::string_view kind, std::string_view key) const;

 private:
  void trim() const;

  std::string folder_;
  std::uint64_t most_bytes_;
};

}  // namespace stemwise
