// A thread of its own for work that waits for things to do.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

namespace shatterpave {

// Runs `work` on a thread of its own, beside everything else. When this dies, the token asks it to stop, and its end is waited
// for. `work` must not throw.
class Background {
 public:
  explicit Background(std::function<void(const std::stop_token& stopped)> work);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace shatterpave
