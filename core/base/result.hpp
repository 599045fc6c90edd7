#pragma once
#include <optional>
#include <utility>

#include "core/base/issue.hpp"

namespace stemwise {

/// A value that may be missing, with everything there is to say about how it came: bad input is a value, not a throw.
template <class T>
struct Result {
  std::optional<T> value;
  Issues issues;

  Result() = default;
  Result(T v) : value(std::move(v)) {}
  Result(T v, Issues i) : value(std::move(v)), issues(std::move(i)) {}

  static Result failure(Issue issue) {
    issue.severity = Severity::error;
    Result r;
    r.issues.push_back(std::move(issue));
    return r;
  }
  static Result failure(Issues issues) {
    Result r;
    r.issues = std::move(issues);
    return r;
  }

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

/// For work that has no value of its own, such as writing a file.
struct Done {
  bool operator==(const Done&) const = default;
};

}  // namespace stemwise
