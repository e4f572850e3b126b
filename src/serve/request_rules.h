// Which requests are answered at all: those of this machine's own pages and programs, for what there is, and no larger than
// need be. Pages from elsewhere that a browser shows may send requests to 127.0.0.1, under any name that resolves to it: so
// Host is looked at (DNS rebinding), and Origin, Sec-Fetch-Site and the type of the content (requests across sites).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace shatterpave::serve {

inline constexpr std::size_t largest_body_bytes = 256 * 1024;  // of a POST; a scene's values take far less

// What is known of a request before its body is read.
struct RequestHead {
  std::string method;
  std::string host;             // the header Host; empty where there is none
  std::string origin;           // Origin; the same
  std::string fetch_site;       // Sec-Fetch-Site
  std::string content_type;     // Content-Type
  std::string content_length;   // Content-Length
  bool has_other_body = false;  // a body in chunks, or in another coding
  bool has_range = false;       // asks for a part of what there is
};

struct Refusal {
  int status = 0;
  std::string_view why;
};

// Nothing where the request may be answered. `port` is ours.
std::optional<Refusal> refusal_of(const RequestHead& head, int port);

}  // namespace shatterpave::serve
