// Pieces that lie side by side: where they touch, and the two as one. Their common border was rounded to the lattice for each
// of them, so that it lies twice, up to `same_line_mm` apart.
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

// 1.42 µm, two diagonals of half a lattice cell, and some room.
inline constexpr double same_line_mm = 0.002;

// A part of a side that touches another polygon.
struct Contact {
  std::size_t side = 0;  // from vertex `side` to the next
  double from_mm = 0.0;  // along it, from < to
  double to_mm = 0.0;
};

// Where the sides of `polygon` touch those of `other`, which run against them; in no order.
std::vector<Contact> contacts(const geometry::Polygon& polygon, const geometry::Polygon& other);

// Length of all contacts.
double shared_length(const geometry::Polygon& a, const geometry::Polygon& b);

// The two pieces as one: the border between them is made the same for both, and taken out. Nothing if they do not make one
// simple polygon.
std::optional<geometry::Polygon> joined(const geometry::Polygon& a, const geometry::Polygon& b);

}  // namespace shatterpave::paving
