// Makes one function object of several, for std::visit, which compiles only if every alternative is handled.
#pragma once

namespace shatterpave {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
// clang 14 does not deduce this by itself.
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace shatterpave
