// Requests that are refused before anything of them is read.
#include "serve/request_rules.h"

#include <gtest/gtest.h>

#include <string>

namespace shatterpave::serve {

namespace {

constexpr int served_port = 8467;

RequestHead good_get() {
  RequestHead head;
  head.method = "GET";
  head.host = "127.0.0.1:8467";
  return head;
}

RequestHead good_post() {
  RequestHead head = good_get();
  head.method = "POST";
  head.origin = "http://127.0.0.1:8467";
  head.fetch_site = "same-origin";
  head.content_type = "application/json";
  head.content_length = "20";
  return head;
}

int status_of(const RequestHead& head) {
  const auto refusal = refusal_of(head, served_port);
  return refusal ? refusal->status : 200;
}

}  // namespace

TEST(RequestRules, TakeWhatThePageSends) {
  EXPECT_EQ(status_of(good_get()), 200);
  EXPECT_EQ(status_of(good_post()), 200);
  RequestHead head = good_post();
  head.host = "localhost:8467";
  head.origin = "http://localhost:8467";
  head.content_type = "application/json; charset=utf-8";
  EXPECT_EQ(status_of(head), 200);
  head.origin = "";  // no browser: a program of this machine
  head.fetch_site = "";
  EXPECT_EQ(status_of(head), 200);
}

TEST(RequestRules, RefuseOtherHosts) {
  for (const char* host : {"", "evil.example", "evil.example:8467", "127.0.0.1", "127.0.0.1:80", "localhost", "127.0.0.1:84670",
                           "127.0.0.1:8467.evil.example", "[::1]:8467", "0.0.0.0:8467", "LOCALHOST.:8467"}) {
    RequestHead head = good_get();
    head.host = host;
    EXPECT_EQ(status_of(head), 403) << host;
    head = good_post();
    head.host = host;
    EXPECT_EQ(status_of(head), 403) << host;
  }
}

TEST(RequestRules, RefuseOtherPages) {
  for (const char* origin : {"null", "many", "http://evil.example", "https://127.0.0.1:8467", "http://127.0.0.1:8468",
                             "http://127.0.0.1:8467.evil.example", "http://127.0.0.1:8467/"}) {
    RequestHead head = good_post();
    head.origin = origin;
    EXPECT_EQ(status_of(head), 403) << origin;
  }
  for (const char* site : {"cross-site", "same-site"}) {
    RequestHead head = good_get();
    head.fetch_site = site;
    EXPECT_EQ(status_of(head), 403) << site;
  }
}

TEST(RequestRules, RefuseBodiesThatAreLargeOrNotTold) {
  const auto with_length = [](const std::string& length) {
    RequestHead head = good_post();
    head.content_length = length;
    return status_of(head);
  };
  EXPECT_EQ(with_length(std::to_string(largest_body_bytes)), 200);
  EXPECT_EQ(with_length(std::to_string(largest_body_bytes + 1)), 413);
  EXPECT_EQ(with_length("1073741824"), 413);
  EXPECT_EQ(with_length("99999999999999999999999999"), 413);
  for (const char* length : {"", "-1", "+5", " 5", "5 ", "0x10", "five"}) EXPECT_EQ(with_length(length), 411) << length;
  RequestHead head = good_post();
  head.has_other_body = true;
  EXPECT_EQ(status_of(head), 411);
  head = good_get();
  head.content_length = "5";
  EXPECT_EQ(status_of(head), 413);
}

TEST(RequestRules, RefuseOtherTypesMethodsAndParts) {
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x"}) {
    RequestHead head = good_post();
    head.content_type = type;
    EXPECT_EQ(status_of(head), 415) << type;
  }
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "CONNECT", "PRI"}) {
    RequestHead head = good_get();
    head.method = method;
    EXPECT_EQ(status_of(head), 405) << method;
  }
  RequestHead head = good_get();
  head.has_range = true;
  EXPECT_EQ(status_of(head), 416);
}

}  // namespace shatterpave::serve
