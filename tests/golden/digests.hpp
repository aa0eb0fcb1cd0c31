// What query_digest() gives on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0xff66483aef656cafu;
inline constexpr uint64_t kFixed16Digest = 0x45f26e5a5ea4b011u;
inline constexpr uint64_t kFloatDigest = 0x26cc3448f98c2619u;

}  // namespace nearfield::golden
