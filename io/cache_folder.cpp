#include "io/cache_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <tuple>
#include <utility>

namespace stemwise {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".stemwise-cache";  // nobody else's: what has it may be deleted
constexpr std::string_view unfinished = ".unfinished";
constexpr std::uint64_t magic = 0x31656863'61637773;  // "swcache1", and the byte order with it
constexpr std::uint64_t most_parts = 16;

/// What a file begins with; behind it the sizes of the parts, the key, the parts.
struct Head {
  std::uint64_t magic = 0, sum = 0, key_size = 0, parts = 0;
};

/// Four sums side by side: as quick as memory is. Not against malice, only against damage.
std::uint64_t sum_of(std::span<const std::byte> bytes, std::uint64_t start) {
  constexpr std::uint64_t prime = 0x9e3779b97f4a7c15;
  std::array<std::uint64_t, 4> lanes{start + 1, start + 2, start + 3, start + 4};
  std::array<std::uint64_t, 4> words{};
  const auto mix = [&] {
    for (std::size_t l = 0; l < 4; ++l) {
      lanes[l] = (lanes[l] ^ words[l]) * prime;
      lanes[l] ^= lanes[l] >> 32;
    }
  };
  std::size_t at = 0;
  for (; at + sizeof words <= bytes.size(); at += sizeof words) {
    std::memcpy(words.data(), bytes.data() + at, sizeof words);
    mix();
  }
  words = {};
  if (at < bytes.size()) std::memcpy(words.data(), bytes.data() + at, bytes.size() - at);
  mix();
  std::uint64_t sum = bytes.size();
  for (const std::uint64_t lane : lanes) sum = (sum ^ lane ^ (lane >> 29)) * prime;
  return sum;
}

/// Calls take(piece) for pieces that a core's cache holds, an empty one where there are no bytes, until one fails.
template <class Byte, class Take>
bool each_piece(std::span<Byte> bytes, Take take) {
  constexpr std::size_t at_once = 256 * 1024;
  do {
    const auto piece = bytes.first(std::min(bytes.size(), at_once));
    if (!take(piece)) return false;
    bytes = bytes.subspan(piece.size());
  } while (!bytes.empty());
  return true;
}

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

bool read_all(int file, std::span<std::byte> into) {
  while (!into.empty()) {
    const ssize_t got = ::read(file, into.data(), into.size());
    if (got <= 0) return false;
    into = into.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(file, bytes.data(), bytes.size());
    if (put <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
  return true;
}

/// The sizes of the parts, when the file is as long as they say and of this key; else nothing.
std::optional<std::vector<std::uint64_t>> read_sizes(int file, const Head& head, std::string_view key) {
  struct stat about {};
  if (head.magic != magic || head.parts > most_parts || head.key_size != key.size() || ::fstat(file, &about) != 0)
    return std::nullopt;
  std::vector<std::uint64_t> sizes(head.parts);
  if (!read_all(file, std::as_writable_bytes(std::span(sizes)))) return std::nullopt;
  std::uint64_t left = static_cast<std::uint64_t>(about.st_size);
  std::vector<std::uint64_t> all = sizes;
  all.push_back(sizeof(Head) + sizes.size() * sizeof(std::uint64_t) + key.size());
  for (const std::uint64_t size : all) {
    if (size > left) return std::nullopt;
    left -= size;
  }
  std::string stored(key.size(), '\0');
  if (left != 0 || !read_all(file, std::as_writable_bytes(std::span(stored))) || stored != key) return std::nullopt;
  return sizes;
}

/// A file that is gone unless it was finished.
class Unfinished {
 public:
  explicit Unfinished(std::string path) : path_(std::move(path) + std::string(unfinished) + "XXXXXX"), file_(::mkostemp(path_.data(), O_CLOEXEC)) {}
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    if (file_ < 0) return;
    ::close(file_);
    if (!finished_) ::unlink(path_.c_str());
  }
  int file() const { return file_; }
  bool finish(const std::string& path) { return finished_ = ::rename(path_.c_str(), path.c_str()) == 0; }

 private:
  std::string path_;
  int file_;
  bool finished_ = false;
};

}  // namespace

CacheReader::CacheReader(int file, std::vector<std::uint64_t> part_sizes, std::uint64_t expected_sum, std::uint64_t sum_so_far)
    : file_(file), sizes_(std::move(part_sizes)), expected_(expected_sum), sum_(sum_so_far) {}
CacheReader::CacheReader(CacheReader&& other) noexcept
    : file_(std::exchange(other.file_, -1)), sizes_(std::move(other.sizes_)), expected_(other.expected_), sum_(other.sum_), next_(other.next_) {}
CacheReader::~CacheReader() {
  if (file_ >= 0) ::close(file_);
}

bool CacheReader::read_next(std::span<std::byte> into) {
  if (next_ >= sizes_.size() || into.size() != sizes_[next_]) return false;
  ++next_;
  return each_piece(into, [&](std::span<std::byte> piece) {
    if (!read_all(file_, piece)) return false;
    sum_ = sum_of(piece, sum_);
    return true;
  });
}

bool CacheReader::is_whole() const { return next_ == sizes_.size() && sum_ == expected_; }

std::string CacheFolder::path_of(std::string_view kind, std::string_view key) const {
  std::array<char, 17> hex{};
  std::snprintf(hex.data(), hex.size(), "%016llx", static_cast<unsigned long long>(sum_of(bytes_of(key), 0)));
  return (fs::path(folder_) / (std::string(kind) + "-" + hex.data() + std::string(suffix))).string();
}

std::optional<CacheReader> CacheFolder::find(std::string_view kind, std::string_view key) const {
  const int file = ::open(path_of(kind, key).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  Head head;
  const bool begun = read_all(file, std::as_writable_bytes(std::span(&head, 1)));
  auto sizes = begun ? read_sizes(file, head, key) : std::nullopt;
  if (!sizes) {
    ::close(file);
    return std::nullopt;
  }
  ::futimens(file, nullptr);  // used now; where that is not allowed the entry only goes earlier
  return CacheReader(file, std::move(*sizes), head.sum, sum_of(bytes_of(key), 0));
}

bool CacheFolder::keep(std::string_view kind, std::string_view key, std::span<const std::span<const std::byte>> parts) const {
  std::vector<std::uint64_t> sizes;
  for (const auto& part : parts) sizes.push_back(part.size());
  const std::uint64_t size = std::accumulate(sizes.begin(), sizes.end(), sizeof(Head) + 8 * sizes.size() + key.size());
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error || size > most_bytes_ || parts.size() > most_parts) return false;
  Head head{magic, sum_of(bytes_of(key), 0), key.size(), parts.size()};
  for (const auto& part : parts) each_piece(part, [&](auto piece) { return head.sum = sum_of(piece, head.sum), true; });
  const std::string path = path_of(kind, key);
  Unfinished writing(path);
  bool written = writing.file() >= 0 && write_all(writing.file(), std::as_bytes(std::span(&head, 1))) &&
                 write_all(writing.file(), std::as_bytes(std::span(sizes))) && write_all(writing.file(), bytes_of(key));
  for (const auto& part : parts) written = written && write_all(writing.file(), part);
  if (!written || !writing.finish(path)) return false;
  trim();
  return true;
}

void CacheFolder::trim() const {
  struct Kept {
    fs::file_time_type used;
    std::uint64_t size;
    fs::path path;
  };
  std::vector<Kept> kept;
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (auto entry = fs::directory_iterator(folder_, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code gone;  // by another process: nothing to do
    const std::string name = entry->path().filename().string();
    const auto used = entry->last_write_time(gone);
    if (gone) continue;
    if (name.ends_with(suffix)) kept.push_back({used, entry->file_size(gone), entry->path()});
    const bool left_behind = name.find(std::string(suffix) + std::string(unfinished)) != std::string::npos && now - used > std::chrono::hours(1);
    if (left_behind) fs::remove(entry->path(), gone);
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return std::tie(a.used, a.path) > std::tie(b.used, b.path); });
  std::uint64_t total = 0;
  for (const Kept& k : kept) {
    total += k.size;
    if (total > most_bytes_) fs::remove(k.path, error);
  }
}

}  // namespace stemwise
