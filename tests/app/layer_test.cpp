// The star of docs/architecture.md, read from every #include there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/base/parallel.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path root = STEMWISE_SOURCE_DIR;
const std::vector<std::string> layers{"core", "io", "render", "ui", "app"};

struct Include {
  std::string name;
  int line = 0;
};

std::vector<fs::path> files_of(const std::string& layer, const std::set<std::string>& suffixes) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / layer)) {
    if (suffixes.contains(entry.path().extension().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Include> includes_of(const fs::path& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  std::ifstream in(file);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::smatch match;
    if (std::regex_search(text, match, pattern)) found.push_back({match[1], line});
  }
  return found;
}

/// "core" for "core/base/issue.hpp", "" for whatever is not ours.
std::string layer_of(const std::string& include) {
  const std::string first = include.substr(0, include.find('/'));
  return include.find('/') != std::string::npos && std::count(layers.begin(), layers.end(), first) == 1 ? first : "";
}

std::string place(const fs::path& file, const Include& include) {
  return fs::relative(file, root).string() + ":" + std::to_string(include.line) + " includes " + include.name;
}

/// True for a header of C++: no folder in its name and no .h; and for the compiler's own SSE2, which every x86-64 has.
bool is_standard(const std::string& include) {
  static const std::regex plain("^[a-z_0-9]+$");
  return std::regex_match(include, plain) || include == "emmintrin.h";
}

TEST(Layers, EachLayerIncludesOnlyWhatTheStarAllows) {
  const std::map<std::string, std::set<std::string>> allowed{
      {"core", {"core"}}, {"io", {"io", "core"}}, {"render", {"render", "core"}}, {"ui", {"ui", "core"}},
      {"app", {"app", "core", "io", "render", "ui"}}};
  int checked = 0;
  for (const std::string& layer : layers) {
    for (const fs::path& file : files_of(layer, {".hpp", ".cpp", ".h"})) {
      for (const Include& include : includes_of(file)) {
        const std::string other = layer_of(include.name);
        EXPECT_TRUE(other.empty() || allowed.at(layer).contains(other)) << place(file, include);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 100);
}

bool is_third_party(const std::string& include) {
  return layer_of(include).empty() && !is_standard(include) && !include.starts_with("Eigen/");
}

/// The third-party header that a header of ours reaches through headers of ours, "" for none.
std::string third_party_behind(const std::string& header, std::set<std::string>& seen) {
  if (!seen.insert(header).second) return "";
  for (const Include& include : includes_of(root / header)) {
    if (is_third_party(include.name)) return header + " includes " + include.name;
    if (layer_of(include.name).empty()) continue;
    if (const std::string behind = third_party_behind(include.name, seen); !behind.empty()) return behind;
  }
  return "";
}

std::string third_party_behind(const std::string& header) {
  std::set<std::string> seen;
  return third_party_behind(header, seen);
}

TEST(Layers, WhatALayerShowsToOthersNamesNoThirdPartyButEigen) {
  int crossings = 0;
  for (const std::string& layer : layers) {
    for (const fs::path& file : files_of(layer, {".hpp", ".cpp"})) {
      for (const Include& include : includes_of(file)) {
        const std::string other = layer_of(include.name);
        if (other.empty() || other == layer) continue;
        EXPECT_EQ(third_party_behind(include.name), "") << place(file, include);
        ++crossings;
      }
    }
  }
  EXPECT_GT(crossings, 50);
}

TEST(Layers, HeadersOfCoreNameNoThirdPartyButEigen) {
  for (const fs::path& file : files_of("core", {".hpp"})) {
    for (const Include& include : includes_of(file)) EXPECT_FALSE(is_third_party(include.name)) << place(file, include);
  }
}

TEST(Layers, CoreKnowsNoFileFormatNoPictureAndNoWindow) {
  const std::vector<std::string> allowed{"Eigen/", "ceres/", "nanoflann", "GeographicLib/"};
  for (const fs::path& file : files_of("core", {".cpp"})) {
    for (const Include& include : includes_of(file)) {
      const bool fine = !layer_of(include.name).empty() || is_standard(include.name) ||
                        std::any_of(allowed.begin(), allowed.end(), [&](const std::string& a) { return include.name.starts_with(a); });
      EXPECT_TRUE(fine) << place(file, include);
    }
  }
}

TEST(Layers, OnlyTheCommandLineFilesSeeCli11) {
  for (const std::string& layer : layers) {
    for (const fs::path& file : files_of(layer, {".hpp", ".cpp"})) {
      for (const Include& include : includes_of(file)) {
        const bool allowed = file.filename().string().starts_with("command_line") && file.extension() == ".cpp";
        EXPECT_TRUE(allowed || !include.name.starts_with("CLI/")) << place(file, include);
      }
    }
  }
}

/// All but the internal ones that need a third party's include path.
TEST(Layers, EveryPublicHeaderCompilesAlone) {
  std::vector<fs::path> headers;
  for (const std::string& layer : layers) {
    for (const fs::path& header : files_of(layer, {".hpp"})) {
      if (third_party_behind(fs::relative(header, root).string()).empty()) headers.push_back(header);
    }
  }
  std::vector<int> outcome(headers.size(), -1);
  stemwise::parallel_for(headers.size(), 2, [&](std::size_t i) {
    const std::string command = "g++ -std=c++20 -fsyntax-only -x c++ -I'" + root.string() + "' -isystem /usr/include/eigen3 '" +
                                headers[i].string() + "' 2>/dev/null";
    outcome[i] = std::system(command.c_str());
  });
  for (std::size_t i = 0; i < headers.size(); ++i) EXPECT_EQ(outcome[i], 0) << headers[i] << " does not compile alone";
}

TEST(Layers, MainStaysUnderSixtyLines) {
  std::ifstream in(root / "app/main.cpp");
  EXPECT_LT(std::count(std::istreambuf_iterator<char>(in), {}, '\n'), 60);
}

}  // namespace
