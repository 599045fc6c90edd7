#include "io/memory_folder.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <atomic>

namespace stemwise {

MemoryFolder::MemoryFolder() {
  static std::atomic<unsigned> made{0};  // a name of its own in the one file system that GDAL keeps per process
  folder_ = "/vsimem/stemwise-" + std::to_string(made++);
  VSIMkdir(folder_.c_str(), 0700);
}

MemoryFolder::~MemoryFolder() { VSIRmdirRecursive(folder_.c_str()); }

std::vector<std::string> MemoryFolder::names() const {
  const CPLStringList list(VSIReadDir(folder_.c_str()));
  std::vector<std::string> names;
  for (int i = 0; i < list.Count(); ++i)
    if (const std::string name = list[i]; name != "." && name != "..") names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string MemoryFolder::bytes_of(const std::string& name) const {
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(path_of(name).c_str(), &size, FALSE);
  return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

}  // namespace stemwise
