#include "core/treeloc/settings.hpp"

namespace stemwise::treeloc {
namespace {

void append(Fields& all, Fields more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

const char* to_string(Method method) {
  switch (method) {
    case Method::stemwise:
      return "stemwise";
    case Method::treelocpp:
      return "treeloc++";
    case Method::treeloc:
      return "treeloc";
  }
  return "";
}

std::optional<Method> method_from(const std::string& word) {
  for (const Method m : {Method::stemwise, Method::treelocpp, Method::treeloc}) {
    if (word == to_string(m)) return m;
  }
  return std::nullopt;
}

Fields Settings::fields() {
  Fields all;
  append(all, scene.fields("scene"));
  append(all, axes.fields("axes"));
  append(all, triangles.fields("triangles"));
  append(all, vote.fields("vote"));
  append(all, match.fields("match"));
  append(all, verify.fields("verify"));
  append(all, refine.fields("refine"));
  append(all, fuse.fields("fuse"));
  return all;
}

Settings settings_for(Method method, const std::string& preset) {
  Settings s;
  s.method = method;
  (void)preset;
  return s;
}

Settings resolve_settings(const Settings& settings, const FrameSet&) { return settings; }

}  // namespace stemwise::treeloc
