#include "serve/request_rules.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace shatterpave::serve {

namespace {

bool is_our_host(std::string_view host, int port) {
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

std::optional<std::size_t> length_of(std::string_view text) {
  std::size_t length = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, length);
  if (error == std::errc::result_out_of_range) return largest_body_bytes + 1;
  if (error != std::errc{} || stop != end) return std::nullopt;
  return length;
}

std::optional<Refusal> refusal_of_post(const RequestHead& head) {
  if (head.has_other_body) return Refusal{411, "expected a body with its length"};
  const auto length = length_of(head.content_length);
  if (!length) return Refusal{411, "expected a Content-Length"};
  if (*length > largest_body_bytes) return Refusal{413, "expected a body of at most 256 KiB"};
  const std::string_view type = std::string_view(head.content_type).substr(0, head.content_type.find(';'));
  if (type != "application/json") return Refusal{415, "expected the content type application/json"};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> refusal_of(const RequestHead& head, int port) {
  if (!is_our_host(head.host, port)) return Refusal{403, "expected the host 127.0.0.1 or localhost with this port"};
  constexpr std::string_view scheme = "http://";
  const std::string_view origin = head.origin;
  if (!origin.empty() && !(origin.starts_with(scheme) && is_our_host(origin.substr(scheme.size()), port))) {
    return Refusal{403, "expected a page of this address"};
  }
  const std::string_view site = head.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none") return Refusal{403, "expected a page of this address"};
  if (head.has_range) return Refusal{416, "expected a request for the whole"};
  if (head.method == "POST") return refusal_of_post(head);
  if (head.method != "GET" && head.method != "HEAD") return Refusal{405, "expected GET, HEAD or POST"};
  const bool has_body = head.has_other_body || (!head.content_length.empty() && head.content_length != "0");
  if (has_body) return Refusal{413, "expected no body"};
  return std::nullopt;
}

}  // namespace shatterpave::serve
