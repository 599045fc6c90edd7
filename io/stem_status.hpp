#pragma once
#include <string_view>

#include "core/forest/stem.hpp"

namespace stemwise {

/// What a field crew's code says: A, alive, L, Li, live, 1, true; D, dead, G (gone), snag, 2, 0, false, ... Unknown codes are
/// `unknown`. `numbers_from_one`: 1 alive, 2 dead (FIA); else 1 alive, 0 dead.
StemStatus stem_status_from(std::string_view code, bool numbers_from_one);

}  // namespace stemwise
