#include "cli/built_with.h"

#include <fmt/format.h>
#include <shatterpave/version.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <string_view>

namespace shatterpave::cli {

namespace {

#ifdef __clang__
constexpr std::string_view compiler = "Clang " __clang_version__;
#else
constexpr std::string_view compiler = "GCC " __VERSION__;
#endif

}  // namespace

std::string version_text() {
  return fmt::format("shatterpave {}\nbuilt by {}, with Boost {}.{}.{}, Bullet {}, CLI11 {}, fmt {}.{}.{}, OpenImageIO {}\n",
                     SHATTERPAVE_VERSION, compiler, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100,
                     SHATTERPAVE_BULLET, CLI11_VERSION, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     SHATTERPAVE_OPENIMAGEIO);
}

}  // namespace shatterpave::cli
