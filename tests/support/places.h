// Where the repository and the command under test lie. Only places.cpp knows: all else compiles to the same in every checkout.
#pragma once

#include <filesystem>
#include <string>

namespace shatterpave::support {

std::filesystem::path source_folder();
std::string command();

}  // namespace shatterpave::support
