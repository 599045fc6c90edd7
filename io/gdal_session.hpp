#pragma once
#include <mutex>
#include <string>
#include <vector>

namespace stemwise {

/// Registers GDAL's drivers once per process. Any number of calls, from any thread.
void register_gdal();

/// While it lives, GDAL's messages of this thread are gathered here in place of going to stderr.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  const std::vector<std::string>& errors() const { return errors_; }
  std::string last_error() const { return errors_.empty() ? std::string() : errors_.back(); }
  void add(std::string text) { errors_.push_back(std::move(text)); }

 private:
  std::vector<std::string> errors_;
};

/// While it lives, a GDAL configuration option of this thread has this value.
class GdalOption {
 public:
  GdalOption(std::string key, const std::string& value);
  ~GdalOption();
  GdalOption(const GdalOption&) = delete;
  GdalOption& operator=(const GdalOption&) = delete;

 private:
  std::string key_;
};

}  // namespace stemwise
