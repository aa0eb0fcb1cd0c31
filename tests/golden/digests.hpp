// What query_digest() gives on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0xb40e4ecbab6b9673u;
inline constexpr uint64_t kFixed16Digest = 0x78f384300fac8d5du;
inline constexpr uint64_t kFloatDigest = 0x509ff2d81bc0f217u;

}  // namespace nearfield::golden
