# Compile options, on targets only.

# What makes results repeatable, on every target that computes: no contraction to FMA, so that a sum of
# products has the same last bit on every x86-64 processor. (-march=native is never set for the same reason.)
add_library(shatterpave_repeatable INTERFACE)
target_compile_features(shatterpave_repeatable INTERFACE cxx_std_20)
target_compile_options(shatterpave_repeatable INTERFACE -ffp-contract=off -fno-fast-math)

add_library(shatterpave_warnings INTERFACE)
target_compile_options(shatterpave_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Wcast-align -Wdouble-promotion -Wnull-dereference
  $<$<BOOL:${SHATTERPAVE_WERROR}>:-Werror>)

if(SHATTERPAVE_SANITIZE)
  add_compile_options(-fsanitize=${SHATTERPAVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${SHATTERPAVE_SANITIZE})
endif()

# What harnesses of libFuzzer follow in the code that they try (tests/fuzz).
if(SHATTERPAVE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# shatterpave_precompile(TARGET HEADER…): those and the standard library's, where that is asked for. Sources include what they use
# all the same: clang-tidy reads them without.
function(shatterpave_precompile target)
  if(SHATTERPAVE_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <span>
      <string> <string_view> <variant> <vector> ${ARGN})
  endif()
endfunction()
