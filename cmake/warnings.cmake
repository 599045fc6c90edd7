# One interface target that every target of ours links: warnings, include root, linker, sanitizers.
# -Wno-missing-field-initializers: members have defaults, so that leaving the rest out is meant.
add_library(stemwise_flags INTERFACE)
target_compile_options(stemwise_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror
  -Wno-restrict -Wno-missing-field-initializers  # GCC 12 sees ghosts in "literal" + std::string (GCC bug 105651)
  -ffp-contract=off)  # the same numbers on every machine: no fused multiply-add behind our back
target_include_directories(stemwise_flags INTERFACE ${CMAKE_SOURCE_DIR})
find_program(LLD ld.lld)
if(LLD)
  target_link_options(stemwise_flags INTERFACE -fuse-ld=lld)
endif()
target_link_options(stemwise_flags INTERFACE -Wl,--as-needed)
if(STEMWISE_SANITIZE)
  target_compile_options(stemwise_flags INTERFACE -fsanitize=${STEMWISE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(stemwise_flags INTERFACE -fsanitize=${STEMWISE_SANITIZE})
endif()
