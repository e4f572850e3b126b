// One function of several, for std::visit: it compiles only where each alternative has one.
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
