#pragma once
#include <string_view>

#include "core/forest/stem_status.hpp"

namespace stemwise {

/// What a field crew's code or word says, in English, German, French, Spanish, Portuguese and Italian: A, alive, 1, true; D, dead,
/// G (gone), snag, fallen, 2, 0, false; cut, stump, harvested, gefällt are `removed`; missing, "not found" are `missing`. What is
/// none of these is `unknown`. `numbers_from_one`: 1 alive, 2 dead (FIA); else 1 alive, 0 dead.
StemStatus status_from_code(std::string_view code, bool numbers_from_one);

}  // namespace stemwise
