#include "scene/plans/geojson_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;

constexpr int deepest_nesting = 64;  // a FeatureCollection's coordinates are 8 deep

// Between values: white space of JSON, and the record separator.
constexpr std::string_view separators = " \t\r\n\x1E";

std::string in_brackets(const json& array) {
  std::string list;
  for (const json& value : array) {
    const bool text = value.is_string();
    list += (list.empty() ? "" : ", ") + (text ? in_quotes(value.get_ref<const std::string&>()) : value.dump());
  }
  return "[" + list + "]";
}

// A part of a text, and where it starts.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The end of the object or array that starts at `begin`: its last bracket, or of the text if that is missing.
std::size_t end_of_value(std::string_view text, std::size_t begin) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      if (--depth == 0) return i + 1;
    }
  }
  return text.size();
}

// The values of a text, one or more. What is no object or array is left to the parser, with all that follows.
std::vector<Part> parts_of(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::vector<Part> parts;
  std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  for (at = text.find_first_not_of(separators, at); at < text.size(); at = text.find_first_not_of(separators, at)) {
    const bool structured = text[at] == '{' || text[at] == '[';
    const std::size_t end = structured ? end_of_value(text, at) : text.size();
    parts.push_back({at, end});
    at = end;
  }
  if (parts.empty()) parts.push_back({0, text.size()});
  return parts;
}

json parsed(std::string_view text, const Part& part, const std::string& file) {
  const auto place_of = [&](std::size_t byte) {
    const TextPosition position = text_position(text, byte);
    return Place{file, position.line, position.column, ""};
  };
  const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
    if (depth <= deepest_nesting) return true;
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected at most {} levels of nesting, got more", deepest_nesting));
  };
  const std::string_view value = text.substr(part.begin, part.end - part.begin);
  try {
    return json::parse(value, limit_depth);
  } catch (const json::parse_error& error) {
    throw InputError(place_of(part.begin + (error.byte > 0 ? error.byte - 1 : 0)), "expected JSON, got a syntax error");
  } catch (const json::out_of_range& error) {
    // "… number overflow parsing '1e400'": the number is nowhere before, or it would have been refused there.
    const std::string_view what = error.what();
    const std::size_t quote = std::min(what.find('\''), what.size());
    const std::string_view number = what.substr(quote).substr(std::min<std::size_t>(1, what.size() - quote));
    const std::string_view digits = number.substr(0, number.find('\''));
    throw InputError(place_of(part.begin + std::min(value.find(digits), value.size())),
                     fmt::format("expected a number that a double can hold, got {}", in_quotes(digits)));
  } catch (const json::exception& error) {
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected JSON, got {}", in_quotes(error.what())));
  }
}

}  // namespace

std::vector<JsonRecord> json_records(std::string_view text, const std::string& file) {
  const std::vector<Part> parts = parts_of(text);
  const TextIndex index(parts.size() > 1 ? text : std::string_view());
  std::vector<JsonRecord> records;
  records.reserve(parts.size());
  for (const Part& part : parts) {
    Place place{file, 0, 0, ""};
    if (parts.size() > 1) {
      const TextPosition position = index.position(part.begin);
      place = {file, position.line, position.column, ""};
    }
    records.push_back({parsed(text, part, file), std::move(place)});
  }
  return records;
}

void refuse_json(const Place& record, const std::string& path, std::string_view expected, std::string_view got) {
  Place place = record;
  place.key = path;
  throw InputError(place, fmt::format("expected {}, got {}", expected, got));
}

std::string kind_of(const json& value) {
  if (value.is_string()) return fmt::format("the text {}", in_quotes(value.get_ref<const std::string&>()));
  if (value.is_number() || value.is_boolean()) return value.dump();
  constexpr std::size_t short_array = 4;
  if (value.is_array() && value.size() <= short_array && std::ranges::none_of(value, &json::is_structured))
    return in_brackets(value);
  if (value.is_array()) return fmt::format("an array of {} value{}", value.size(), value.size() == 1 ? "" : "s");
  return value.is_null() ? "null" : "an object";
}

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

}  // namespace shatterpave::scene
