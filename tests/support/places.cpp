#include "support/places.h"

namespace shatterpave::support {

std::filesystem::path source_folder() { return SHATTERPAVE_SOURCE_DIR; }

std::string command() { return SHATTERPAVE_COMMAND; }

}  // namespace shatterpave::support
