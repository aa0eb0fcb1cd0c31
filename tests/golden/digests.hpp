// What query_digest() gives on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0x1eec0b41f56c7ba8u;
inline constexpr uint64_t kFixed16Digest = 0x2f84d8eb596d891bu;
inline constexpr uint64_t kFloatDigest = 0x84e92d06b9539653u;

}  // namespace nearfield::golden
