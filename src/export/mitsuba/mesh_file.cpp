#include "export/mitsuba/mesh_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "core/error.h"

namespace shatterpave::exporting::mitsuba {

namespace {

// Whole numbers that a float holds.
constexpr std::uint32_t most_bodies = 1U << 24U;

}  // namespace

MeshFile::MeshFile() : mesh_({.target = "mitsuba", .uv = {"u", "v"}, .faces = "property float body_0\n"}) {}

void MeshFile::begin_body(std::uint32_t number, const shapes::Body& body) {
  if (number >= most_bodies) {
    throw InputError(fmt::format("target mitsuba: expected at most {} bodies, got more", most_bodies));
  }
  const auto as_float = static_cast<float>(number);
  if (as_float == body_) return;
  body_ = as_float;
  mesh_.comment(fmt::format("body {} {} {}", number, body.name, body.kind));
}

void MeshFile::add(const shapes::Mesh& mesh, const shapes::Placing& placing) {
  const auto number = std::bit_cast<std::array<char, sizeof(float)>>(body_);
  mesh_.add(mesh, placing, {number.data(), number.size()});
}

std::string MeshFile::taken() {
  body_ = -1.0F;
  return mesh_.taken();
}

}  // namespace shatterpave::exporting::mitsuba
