// Which cracks touch which: enough to tell when they close a region.
#pragma once

#include <array>
#include <optional>
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
  // A shortest way from `a` to `b`, which must be connected: each further node on it, with the point where it is entered. It
  // costs what lies about the two, however many nodes there are elsewhere.
  std::vector<Contact> way(int a, int b);

 private:
  // How a search from one end came to a node.
  struct Entry {
    int from = -1;  // −1: it did not
    geometry::LatticePoint at;
  };
  // A search from one end: the nodes it came to, those of the last round at the end.
  struct Search {
    std::vector<Entry> entries;  // of every node; those of no node in `seen` are empty
    std::vector<int> seen;
    std::size_t round = 0;  // where in `seen` the last round starts
  };

  int root(int node) const;
  int meeting(Search& search, const Search& other) const;
  std::span<const Contact> contacts(int node) const { return contacts_[static_cast<std::size_t>(node)]; }

  std::vector<std::vector<Contact>> contacts_;
  std::vector<int> parents_;
  std::array<Search, 2> searches_;  // kept, since to make their entries anew would cost as much as there are nodes
};

}  // namespace shatterpave::glass
