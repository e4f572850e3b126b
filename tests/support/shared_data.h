// The data sets that are kept beside the repository, in ../shared/data, and may be absent.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "support/places.h"

namespace shatterpave::support {

// ../shared/data beside the repository, whether it exists or not.
inline std::filesystem::path shared_data() { return source_folder().parent_path() / "shared" / "data"; }

}  // namespace shatterpave::support

// The one reason for which a test may be skipped.
#define SKIP_WITHOUT_SHARED_DATA()                                     \
  if (!std::filesystem::exists(::shatterpave::support::shared_data())) \
  GTEST_SKIP() << "no data at " << ::shatterpave::support::shared_data()
