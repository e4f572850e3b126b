#include "glass/map/contact_graph.h"

#include <algorithm>
#include <utility>

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

// Goes on by one round. Returns a node that both searches have come to; −1 if there is none.
int ContactGraph::meeting(Search& search, const Search& other) const {
  const std::size_t end = search.seen.size();
  for (std::size_t i = std::exchange(search.round, end); i < end; ++i) {
    const int node = search.seen[i];
    for (const Contact& contact : contacts(node)) {
      Entry& entry = search.entries[static_cast<std::size_t>(contact.node)];
      if (entry.from >= 0) continue;
      entry = {node, contact.at};
      search.seen.push_back(contact.node);
      if (other.entries[static_cast<std::size_t>(contact.node)].from >= 0) return contact.node;
    }
  }
  return -1;
}

std::vector<ContactGraph::Contact> ContactGraph::way(int a, int b) {
  ENSURE(a != b && connected(a, b));
  // Most regions are closed by two cracks of one impact: neighbours of neighbours are tried before the search.
  for (const Contact& first : contacts(a)) {
    if (first.node == b) return {first};
    const auto second = std::ranges::find(contacts(b), first.node, &Contact::node);
    if (second != contacts(b).end()) return {first, {b, second->at}};
  }
  auto& [forward, backward] = searches_;
  for (const auto& [search, end] : {std::pair{&forward, a}, std::pair{&backward, b}}) {
    search->entries.resize(contacts_.size());
    search->entries[static_cast<std::size_t>(end)].from = end;
    search->seen = {end};
    search->round = 0;
  }
  int middle = -1;
  while (middle < 0) {
    const bool go_forward = forward.seen.size() - forward.round <= backward.seen.size() - backward.round;
    middle = go_forward ? meeting(forward, backward) : meeting(backward, forward);
  }
  std::vector<Contact> steps;
  const auto entry = [](const Search& search, int node) { return search.entries[static_cast<std::size_t>(node)]; };
  for (int node = middle; node != a; node = entry(forward, node).from) steps.push_back({node, entry(forward, node).at});
  std::ranges::reverse(steps);
  for (int node = middle; node != b; node = entry(backward, node).from) {
    steps.push_back({entry(backward, node).from, entry(backward, node).at});
  }
  for (Search& search : searches_) {
    for (const int node : search.seen) search.entries[static_cast<std::size_t>(node)] = {};
  }
  return steps;
}

}  // namespace shatterpave::glass
