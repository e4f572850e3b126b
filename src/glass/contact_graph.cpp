#include "glass/contact_graph.h"

#include <algorithm>

#include "core/error.h"

namespace shatterpave::glass {

int ContactGraph::add() {
  const int node = static_cast<int>(parents_.size());
  parents_.push_back(-1);
  contacts_.emplace_back();
  return node;
}

// `parents_` holds the parent, or, of a root, minus the size of its set. Union by size keeps every way to the root short.
int ContactGraph::root(int node) const {
  while (parents_[static_cast<std::size_t>(node)] >= 0) node = parents_[static_cast<std::size_t>(node)];
  return node;
}

void ContactGraph::connect(int a, int b, geometry::LatticePoint at) {
  contacts_[static_cast<std::size_t>(a)].push_back({b, at});
  contacts_[static_cast<std::size_t>(b)].push_back({a, at});
  int large = root(a);
  int small = root(b);
  if (large == small) return;
  const auto parent = [this](int node) -> int& { return parents_[static_cast<std::size_t>(node)]; };
  if (parent(large) > parent(small)) std::swap(large, small);
  parent(large) += parent(small);
  parent(small) = large;
}

std::vector<ContactGraph::Contact> ContactGraph::way(int a, int b) const {
  // Most regions are closed by two cracks of one impact: neighbours of neighbours are tried before the search.
  for (const Contact& first : contacts(a)) {
    if (first.node == b) return {first};
    const auto second = std::ranges::find(contacts(b), first.node, &Contact::node);
    if (second != contacts(b).end()) return {first, {b, second->at}};
  }
  std::vector<Contact> entered_from(contacts_.size(), Contact{-1, {}});
  std::vector<int> queue = {a};
  entered_from[static_cast<std::size_t>(a)].node = a;
  for (std::size_t i = 0; i < queue.size() && entered_from[static_cast<std::size_t>(b)].node < 0; ++i) {
    for (const Contact& contact : contacts(queue[i])) {
      Contact& entry = entered_from[static_cast<std::size_t>(contact.node)];
      if (entry.node >= 0) continue;
      entry = {queue[i], contact.at};
      queue.push_back(contact.node);
    }
  }
  ENSURE(entered_from[static_cast<std::size_t>(b)].node >= 0);
  std::vector<Contact> steps;
  for (int node = b; node != a; node = entered_from[static_cast<std::size_t>(node)].node) {
    steps.push_back({node, entered_from[static_cast<std::size_t>(node)].at});
  }
  std::ranges::reverse(steps);
  return steps;
}

}  // namespace shatterpave::glass
