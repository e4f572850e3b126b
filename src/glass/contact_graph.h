// Which cracks touch which: enough to tell when they close a region.
#pragma once

#include <span>
#include <vector>

#include "geometry/lattice.h"

namespace shatterpave::glass {

// A graph of numbered nodes that touch one another in points.
class ContactGraph {
 public:
  struct Contact {
    int node = 0;
    geometry::LatticePoint at;

    bool operator==(const Contact&) const = default;
  };

  // Adds the next node and returns its number.
  int add();
  void connect(int a, int b, geometry::LatticePoint at);

  // Whether there is a way from `a` to `b`: union–find, in practically constant time.
  bool connected(int a, int b) const { return root(a) == root(b); }
  // A shortest way from `a` to `b`, which must be connected: each further node on it, with the point where it is entered.
  std::vector<Contact> way(int a, int b) const;

 private:
  int root(int node) const;
  std::span<const Contact> contacts(int node) const { return contacts_[static_cast<std::size_t>(node)]; }

  std::vector<std::vector<Contact>> contacts_;
  std::vector<int> parents_;
};

}  // namespace shatterpave::glass
