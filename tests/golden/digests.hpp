// What query_digest() gives on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0xe3ab1248b8714defu;
inline constexpr uint64_t kFixed16Digest = 0x4d6c8872a45e3c4eu;
inline constexpr uint64_t kFloatDigest = 0x694c8581a54d175fu;

}  // namespace nearfield::golden
