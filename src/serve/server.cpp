// cpp-httplib reads and writes; what is answered is decided here, before it reads a body, looks for a file or a route: so no
// path of a request reaches the disk, and a body is read only where one is expected and is small. Each connection carries one
// request, since what is left of a refused one would be taken for the next.
#include "serve/server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <netinet/tcp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "scene/schema/key_tables.h"
#include "serve/page.h"
#include "serve/request_rules.h"

namespace shatterpave::serve {

namespace {

using Json = nlohmann::ordered_json;
using httplib::Request;
using httplib::Response;
using std::chrono::milliseconds;

constexpr std::size_t most_listeners = 6;  // pages that wait for events, each of which keeps a thread
constexpr std::size_t most_workers = most_listeners + 6;
constexpr std::size_t most_waiting = 32;  // connections that no thread has taken yet
constexpr int patience_s = 2;             // for a client that has stopped in the middle of a request
constexpr milliseconds beat{50};
constexpr milliseconds farewell{100};
constexpr milliseconds event_interval{1000};  // between two signs of life

// How many connections there are whose requests have not been answered.
class Load {
 public:
  // Waits until there are fewer than `most`, or `stopped` says that nothing more is to come; and adds one.
  void add(std::size_t most, const std::function<bool()>& stopped) {
    std::unique_lock lock(mutex_);
    while (count_ >= most && !stopped()) fewer_.wait_for(lock, beat);
    ++count_;
  }
  void remove() {
    const std::scoped_lock lock(mutex_);
    --count_;
    fewer_.notify_all();
  }
  // Waits until there is none, for that long; whether there is none.
  bool wait_for_none(milliseconds longest) {
    std::unique_lock lock(mutex_);
    return fewer_.wait_for(lock, longest, [&] { return count_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable fewer_;
  std::size_t count_ = 0;
};

// Threads and a queue, both bounded: where the queue is full, connections wait in that of the system, which is short.
class Workers : public httplib::TaskQueue {
 public:
  Workers(std::shared_ptr<Load> load, const std::function<bool()>& stopped, std::function<void()> stop)
      : load_(std::move(load)),
        stopped_(stopped),
        stop_(std::move(stop)),
        pool_(std::make_unique<httplib::ThreadPool>(most_workers)) {}

  void enqueue(std::function<void()> work) override {
    on_idle();
    load_->add(most_workers + most_waiting, stopped_);
    pool_->enqueue([load = load_, work = std::move(work)] {
      work();
      load->remove();
    });
  }
  void on_idle() override {
    if (stopped_()) stop_();
  }
  // A thread that waits for a slow client is left alone: the program is about to end.
  void shutdown() override {
    if (load_->wait_for_none(farewell)) {
      pool_->shutdown();
    } else {
      static_cast<void>(pool_.release());
    }
  }

 private:
  std::shared_ptr<Load> load_;
  const std::function<bool()>& stopped_;
  std::function<void()> stop_;
  std::unique_ptr<httplib::ThreadPool> pool_;
};

// With a length that is known: the library would compress other answers, which costs more than it saves here.
void answer(Response& response, Shared content, const char* type) {
  if (content == nullptr || content->empty()) {
    response.status = content == nullptr ? 404 : 200;
    response.set_content("", type);
    return;
  }
  const std::size_t size = content->size();
  response.status = 200;
  response.set_content_provider(size, type,
                                [content = std::move(content)](std::size_t at, std::size_t length, httplib::DataSink& sink) {
                                  constexpr std::size_t part = std::size_t{1} << 20;
                                  return sink.write(content->data() + at, std::min(length, part));
                                });
}

void answer(Response& response, const PageFile& file) {
  response.status = 200;
  response.set_content_provider(file.text.size(), std::string(file.content_type).c_str(),
                                [text = file.text](std::size_t at, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(text.data() + at, length);
                                });
}

void refuse(Response& response, int status, std::string_view why) {
  response.status = status;
  response.set_content(fmt::format("{}\n", why), "text/plain; charset=utf-8");
}

RequestHead head_of(const Request& request) {
  RequestHead head;
  head.method = request.method;
  // More than one is as none.
  const auto only = [&](const char* name) {
    return request.get_header_value_count(name) == 1 ? request.get_header_value(name) : std::string();
  };
  head.host = only("Host");
  head.origin = request.get_header_value_count("Origin") > 1 ? "many" : request.get_header_value("Origin");
  head.fetch_site = request.get_header_value("Sec-Fetch-Site");
  head.content_type = only("Content-Type");
  head.content_length = only("Content-Length");
  head.has_other_body = request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding");
  head.has_range = request.has_header("Range");
  return head;
}

// A value of JSON as one of TOML: numbers, texts, truth, and lists of numbers.
std::string toml_of(const Json& value) {
  if (value.is_number_integer() || value.is_boolean()) return value.dump();
  if (value.is_number_float()) {
    std::string text = value.dump();
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
  }
  if (value.is_string()) {
    constexpr std::size_t longest = 200;
    const auto& text = value.get_ref<const std::string&>();
    if (text.size() <= longest) return value.dump();  // texts of JSON are texts of TOML
  }
  if (value.is_array() && value.size() >= 2 && value.size() <= 3) {
    std::string list;
    for (const Json& number : value) {
      if (!number.is_number()) throw InputError("expected a list of numbers, got another one");
      list += (list.empty() ? "" : ", ") + number.dump();
    }
    return fmt::format("[{}]", list);
  }
  throw InputError("expected a number, a text, true, false, or a list of two or three numbers, got something else");
}

Json body_of(const Request& request) {
  Json body = Json::parse(request.body, nullptr, false);
  if (!body.is_object()) throw InputError("expected an object of JSON, got something else");
  return body;
}

LiveView::Values values_of(const Request& request) {
  constexpr std::size_t most = 256;
  const Json body = body_of(request);
  if (body.size() > most) throw InputError(fmt::format("expected at most {} values, got {}", most, body.size()));
  LiveView::Values values;
  for (const auto& [key, value] : body.items()) values.emplace_back(key, toml_of(value));
  return values;
}

int side_of(const Json& body, const char* name, int given) {
  constexpr int least = 16;
  constexpr int most = 1920;
  if (!body.contains(name)) return given;
  const Json& side = body[name];
  if (!side.is_number_integer() || side < least || side > most) {
    throw InputError(fmt::format("expected a {} from {} to {} pixels, got another one", name, least, most));
  }
  return side.get<int>();
}

std::optional<std::size_t> number_behind(std::string_view path, std::string_view prefix, std::string_view ending) {
  if (!path.starts_with(prefix) || !path.ends_with(ending) || path.size() <= prefix.size() + ending.size()) return std::nullopt;
  const std::string_view digits = path.substr(prefix.size(), path.size() - prefix.size() - ending.size());
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || stop != digits.data() + digits.size()) return std::nullopt;
  return number;
}

bool is_skippable(const Request& request) {
  constexpr std::size_t most_digits = 6;  // below 1 MB
  return request.method == "POST" && request.get_header_value("Content-Length").size() <= most_digits;
}

constexpr std::array post_paths = {"/set", "/seed", "/revert", "/save", "/render", "/render/stop"};

// Scripts, styles and pictures of this address alone; `blob:` are the textures of the bodies.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; frame-ancestors "
    "'none'; "
    "base-uri 'none'; form-action 'none'";

}  // namespace

class Server::Listener {
 public:
  Listener(LiveView& view, int port) : view_(view), keys_(std::make_shared<const std::string>(scene::keys_json())) {
    server_.set_address_family(AF_INET);
    // Without SO_REUSEPORT, by which two servers would share a port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_tcp_nodelay(true);
    server_.set_keep_alive_max_count(1);
    server_.set_keep_alive_timeout(patience_s);
    server_.set_read_timeout(patience_s, 0);
    server_.set_write_timeout(patience_s, 0);
    server_.set_idle_interval(0, std::chrono::microseconds(beat).count());
    server_.set_payload_max_length(largest_body_bytes);
    server_.set_default_headers({{"Cache-Control", "no-store"},
                                 {"Content-Security-Policy", content_policy},
                                 {"Cross-Origin-Opener-Policy", "same-origin"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"X-Content-Type-Options", "nosniff"}});
    server_.set_expect_100_continue_handler(
        [this](const Request& request, Response& response) { return expectation(request, response); });
    server_.set_pre_routing_handler([this](const Request& request, Response& response) { return answered(request, response); });
    for (const char* path : post_paths) {
      server_.Post(path, [this](const Request& request, Response& response) { answer_post(request, response); });
    }
    bind(port);
  }

  int port() const { return port_; }

  bool run(const std::function<bool()>& stopped) {
    server_.new_task_queue = [&] {
      return new Workers(load_, stopped, [this] {
        is_ending_ = true;
        view_.stop();
        server_.stop();
      });
    };
    server_.listen_after_bind();
    return load_->wait_for_none(milliseconds(0));
  }

 private:
  void bind(int port) {
    constexpr const char* address = "127.0.0.1";
    if (port == 0) {
      port_ = server_.bind_to_any_port(address);
    } else {
      port_ = server_.bind_to_port(address, port) ? port : -1;
    }
    if (port_ > 0) return;
    throw InputError(Place{"shatterpave: --port", 0, 0, ""},
                     fmt::format("expected a port of 127.0.0.1 that is free, got {}, which is taken or not allowed", port));
  }

  // The status that a client is told before it sends a large body.
  int expectation(const Request& request, Response& response) {
    const auto refusal = refusal_of(head_of(request), port_);
    if (!refusal) return 100;
    refuse(response, refusal->status, refusal->why);
    return refusal->status;
  }

  httplib::Server::HandlerResponse answered(const Request& request, Response& response) {
    using Handler = httplib::Server::HandlerResponse;
    if (const auto refusal = refusal_of(head_of(request), port_)) {
      // A body that is not much too large is read and thrown away, so that its sender reads why; the library then says 413.
      if (refusal->status == 413 && is_skippable(request)) return Handler::Unhandled;
      refuse(response, refusal->status, refusal->why);
      return Handler::Handled;
    }
    if (request.method == "POST") {
      if (std::ranges::find(post_paths, request.path) != post_paths.end()) return Handler::Unhandled;
      refuse(response, 404, "there is no such thing here");
      return Handler::Handled;
    }
    answer_get(request, response);
    return Handler::Handled;
  }

  void answer_get(const Request& request, Response& response) {
    const std::string& path = request.path;
    if (const auto file = page_file(path)) return answer(response, *file);
    if (path == "/model.glb") return answer(response, view_.bodies(), "model/gltf-binary");
    if (path == "/values.json") return answer(response, view_.values(), "application/json");
    if (path == "/statistics.json") return answer(response, view_.statistics(), "application/json");
    if (path == "/keys.json") return answer(response, keys_, "application/json");
    if (path == "/state.json") return answer(response, std::make_shared<const std::string>(view_.state()), "application/json");
    if (path == "/render.png") return answer(response, view_.picture(), "image/png");
    if (path == "/scene.toml") return answer_scene(response);
    if (path == "/events") return answer_events(response);
    if (const auto thing = number_behind(path, "/plan/", ".svg"))
      return answer(response, view_.drawing(*thing), "image/svg+xml");
    refuse(response, 404, "there is no such thing here");
  }

  void answer_scene(Response& response) {
    guarded(response,
            [&] { answer(response, std::make_shared<const std::string>(view_.text()), "text/plain; charset=utf-8"); });
  }

  void answer_post(const Request& request, Response& response) {
    guarded(response, [&] {
      const std::string& path = request.path;
      if (path == "/set") view_.set(values_of(request));
      if (path == "/seed") step_seed(request);
      if (path == "/revert") view_.revert();
      if (path == "/save") view_.save();
      if (path == "/render") start_render(request);
      if (path == "/render/stop") view_.stop_render();
      answer(response, std::make_shared<const std::string>(view_.state()), "application/json");
    });
  }

  void step_seed(const Request& request) {
    const Json body = body_of(request);
    constexpr std::int64_t most = 1'000'000;
    if (!body.contains("by") || !body["by"].is_number_integer() || body["by"] < -most || body["by"] > most) {
      throw InputError("expected {\"by\": STEP}, a whole number, got something else");
    }
    view_.step_seed(body["by"].get<std::int64_t>());
  }

  void start_render(const Request& request) {
    const Json body = body_of(request);
    view_.render(side_of(body, "width", 640), side_of(body, "height", 480));
  }

  // What is wrong is told as JSON, with its place.
  template <typename Work>
  static void guarded(Response& response, const Work& work) {
    const auto tell = [&](int status, const std::string& message, const Place& place) {
      const Json error{
          {"message", message}, {"file", place.file}, {"line", place.line}, {"column", place.column}, {"key", place.key}};
      response.status = status;
      response.set_content(error.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json");
    };
    try {
      work();
    } catch (const InputError& error) {
      tell(422, error.message(), error.place());
    } catch (const std::exception& error) {
      tell(500, error.what(), {});
    }
  }

  void answer_events(Response& response) {
    if (listeners_ >= most_listeners) return refuse(response, 503, "too many pages are open");
    ++listeners_;
    response.status = 200;
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, revision = std::uint64_t{0}](std::size_t /*at*/, httplib::DataSink& sink) mutable {
          if (is_ending_) {
            sink.done();
            return true;
          }
          const std::uint64_t now = view_.wait_for_other(revision, event_interval);
          const std::string text = now == revision ? ":\n\n" : fmt::format("data: {}\n\n", view_.state());
          revision = now;
          return sink.write(text.data(), text.size());
        },
        [this](bool /*success*/) { --listeners_; });
  }

  LiveView& view_;
  Shared keys_;
  httplib::Server server_;
  int port_ = 0;
  std::shared_ptr<Load> load_ = std::make_shared<Load>();
  std::atomic<std::size_t> listeners_{0};
  std::atomic<bool> is_ending_{false};
};

Server::Server(LiveView& view, int port) : listener_(std::make_unique<Listener>(view, port)) {}
Server::~Server() = default;
int Server::port() const { return listener_->port(); }
bool Server::run(const std::function<bool()>& stopped) { return listener_->run(stopped); }

}  // namespace shatterpave::serve
