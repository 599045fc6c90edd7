#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace stemwise::testing {

/// What a run of the built program said and how it ended.
struct ProgramRun {
  int code = -1;
  std::string out;
  std::string err;
};

ProgramRun run_stemwise(const std::vector<std::string>& arguments, const std::string& environment = "");
/// Sends Ctrl+C when the program says its first line on stderr.
ProgramRun interrupt_stemwise(const std::vector<std::string>& arguments);

/// A folder of its own, gone with it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::string& path);

}  // namespace stemwise::testing
