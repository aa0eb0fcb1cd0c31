// What query_digest() gives on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0x1bfae7368cdca8ffu;
inline constexpr uint64_t kFixed16Digest = 0x37af4c52be5f1095u;
inline constexpr uint64_t kFloatDigest = 0xb396aab00f69f417u;

}  // namespace nearfield::golden
