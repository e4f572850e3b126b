// The web server of `shatterpave serve`, on this machine's own address 127.0.0.1 alone. docs/serve.md lists what it answers.
#pragma once

#include <functional>
#include <memory>

#include "serve/live_view.h"

namespace shatterpave::serve {

class Server {
 public:
  // Throws InputError where the port, 0 for any that is free, is taken.
  Server(LiveView& view, int port);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  // Answers until `stopped` says so, which is asked at least every 50 ms. Then requests that are being answered have a moment
  // to end; true if none is left. If one is, this object must not die: the program must end.
  bool run(const std::function<bool()>& stopped);

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace shatterpave::serve
