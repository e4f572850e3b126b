#include <shatterpave/version.h>

namespace shatterpave {

namespace {

#define SHATTERPAVE_TEXT_OF(number) #number
#define SHATTERPAVE_TEXT(number) SHATTERPAVE_TEXT_OF(number)
constexpr bool same(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}
static_assert(same(SHATTERPAVE_VERSION, SHATTERPAVE_TEXT(SHATTERPAVE_VERSION_MAJOR) "." SHATTERPAVE_TEXT(
                                            SHATTERPAVE_VERSION_MINOR) "." SHATTERPAVE_TEXT(SHATTERPAVE_VERSION_PATCH)));

}  // namespace

const char* version() { return SHATTERPAVE_VERSION; }

}  // namespace shatterpave
