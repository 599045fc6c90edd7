#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/read_inventory.hpp"

namespace stemwise {

/// How files were read that a person had to explain, by their headers: the next file of the same kind needs no question.
/// Columns, units, status codes and the coordinate system are kept; names, dates and plots belong to one file.
class ImportMemory {
 public:
  /// Nothing where the file is missing or broken. An empty path: nothing is kept beyond this window.
  static ImportMemory read(const std::string& path);

  std::optional<ReadOptions> find(const std::vector<std::string>& header) const;
  /// The newest goes first; what says nothing is forgotten. Writes the file, beside it and renamed.
  void remember(const std::vector<std::string>& header, const ReadOptions& options);
  std::size_t size() const { return entries_.size(); }

 private:
  using Entry = std::pair<std::vector<std::string>, ReadOptions>;
  void write() const;

  std::string path_;
  std::vector<Entry> entries_;
};

}  // namespace stemwise
