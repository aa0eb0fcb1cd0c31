// What query_digest() and entry_digest() give on every compiler, optimisation level and machine.
#pragma once

#include <stdint.h>

namespace nearfield::golden {

inline constexpr uint32_t kDigestQueries = 100000;
inline constexpr uint64_t kFixed27Digest = 0x3ab4ea56e7b069f6u;
inline constexpr uint64_t kFixed16Digest = 0x96eca98f1a38e8dfu;
inline constexpr uint64_t kFloatDigest = 0x74326512fb88be01u;

// Of the first queries of the same stream: the smallest boards have no FPU and take a minute for all of them.
inline constexpr uint32_t kTargetDigestQueries = 25000;
inline constexpr uint64_t kFixed27TargetDigest = 0x2fb874794ef03211u;
inline constexpr uint64_t kFixed16TargetDigest = 0xf2ff81b3dac23fe0u;
inline constexpr uint64_t kFloatTargetDigest = 0x101d714f6db6c4f6u;

inline constexpr uint64_t kFixed27EntryDigest = 0xbb3b3d0c6cdbb71bu;
inline constexpr uint64_t kFixed16EntryDigest = 0xf6303c46bb344235u;
inline constexpr uint64_t kFloatEntryDigest = 0x78fbf6ded93c346fu;

// Of ports/kernel_digest.cpp.
inline constexpr uint64_t kKernelDigest = 0x85e47981978cdaf6u;

}  // namespace nearfield::golden
