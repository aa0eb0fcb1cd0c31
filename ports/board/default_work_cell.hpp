// The player of the work cell that was baked into the image.
#pragma once

#include <work_cell/player.hpp>

#include <work_cell.inc>

// Placement into static memory, without the library header that declares it.
inline void* operator new(size_t, void* at) noexcept { return at; }

namespace nearfield::board {

using Player = work_cell::Player<
    work_cell::kArmLinks, work_cell::kArmBodies, work_cell::kPersonLinks,
    work_cell::kPersonBodies, work_cell::Operations>;

alignas(Player) inline unsigned char player_memory[sizeof(Player)];

// Once, at the start. In static memory and not on the stack, and without a constructor that runs before main().
inline Player& start_player() { return *new (player_memory) Player(work_cell::kWorkCell); }

}  // namespace nearfield::board
