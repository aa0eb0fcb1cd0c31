// What a kernel costs at the worst: the greatest number of instructions over a list of arguments, exact. A
// kernel is a callable that takes one word (uint32_t or float) and returns one word or a ValueAndSlope of
// two.
#pragma once

#include <board/instruction_counter.hpp>

namespace nearfield::board {

template <class Word>
struct ValueAndSlope {
  Word value;
  Word slope;
};

namespace detail {

// What a measured loop reads and writes: the compiler can neither drop the kernel nor move it out of the
// loop.
template <class Argument, class Word>
struct Cells {
  volatile Argument argument;
  volatile Word value;
  volatile Word slope;

  void store(Word result) { value = result; }
  void store(const ValueAndSlope<Word>& result) {
    value = result.value;
    slope = result.slope;
  }
};

template <class Result>
struct ResultOf {
  using Word = Result;
  template <class Argument>
  static Result unchanged(Argument argument) {
    return static_cast<Word>(argument);
  }
};
template <class Result>
struct ResultOf<ValueAndSlope<Result>> {
  using Word = Result;
  template <class Argument>
  static ValueAndSlope<Word> unchanged(Argument argument) {
    return {static_cast<Word>(argument), static_cast<Word>(argument)};
  }
};

template <class Argument, class Kernel>
[[gnu::noipa]] uint32_t loop_instructions(Kernel kernel, Argument argument, uint32_t repetitions) {
  static_assert(__is_class(Kernel),
                "a pointer to a function would be called through the pointer: use a lambda");
  static Cells<Argument, typename ResultOf<decltype(kernel(argument))>::Word> cells;
  cells.argument = argument;
  start_instruction_count();
  for (uint32_t left = repetitions; left != 0; --left) cells.store(kernel(cells.argument));
  return stop_instruction_count();
}

}  // namespace detail

// Instructions of one turn of a loop that reads an argument, applies `kernel` and writes the results;
// constants that the compiler loads once before the loop do not count. 0 if two loops differ by no multiple
// of the turns, which no kernel whose cost depends on its argument alone can cause.
template <class Argument, class Kernel>
uint32_t turn_instructions(Kernel kernel, Argument argument) {
  constexpr uint32_t kTurns = 4;
  const uint32_t few = detail::loop_instructions(kernel, argument, kTurns);
  const uint32_t many = detail::loop_instructions(kernel, argument, 2 * kTurns);
  return (many - few) % kTurns == 0 ? (many - few) / kTurns : 0;
}

// The greatest number of instructions that `kernel` adds to a loop that copies its argument to its results,
// over argument_at(0) ... argument_at(count - 1). Each kernel is compiled into a loop of its own: a callable
// that the compiler inlines is measured in line, one that calls a function with its call. 0 if a measurement
// failed.
template <class Kernel, class ArgumentAt>
uint32_t worst_instruction_count(Kernel kernel, ArgumentAt argument_at, uint32_t count) {
  using Argument = decltype(argument_at(0));
  using Result = decltype(kernel(argument_at(0)));
  const auto copy = [](Argument argument) { return detail::ResultOf<Result>::unchanged(argument); };
  const uint32_t loop = turn_instructions(copy, argument_at(0));
  uint32_t worst = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t turn = turn_instructions(kernel, argument_at(i));
    if (loop == 0 || turn < loop) return 0;
    if (turn - loop > worst) worst = turn - loop;
  }
  return worst;
}

}  // namespace nearfield::board
