// The consumer's own.
#pragma once

inline constexpr bool consumer_has_its_own_error = true;
