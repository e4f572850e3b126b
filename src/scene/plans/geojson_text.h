// The text of a GeoJSON file as JSON values, and what is said of values in messages.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace shatterpave::scene {

// A value of a file, with the place where it starts if the file has several.
struct JsonRecord {
  nlohmann::json value;
  Place place;
};

// The value of a text; or its values, where several follow each other: one a line (GeoJSON lines), each after a record
// separator (RFC 8142), or simply one after another. A byte order mark is passed over. Throws InputError where the text is not
// JSON.
std::vector<JsonRecord> json_records(std::string_view text, const std::string& file);

// Throws InputError: "expected …, got …" at `path` of the record.
[[noreturn]] void refuse_json(const Place& record, const std::string& path, std::string_view expected, std::string_view got);

// What a value is, for "got …".
std::string kind_of(const nlohmann::json& value);

// The path of a member.
std::string joined(const std::string& path, std::string_view key);

}  // namespace shatterpave::scene
