// What a kernel costs at the worst: the greatest number of instructions over a list of arguments, exact. A
// kernel is a callable that takes and returns words (uint32_t, int32_t or float): one, or Several.
#pragma once

#include <stddef.h>

#include <board/instruction_counter.hpp>

namespace nearfield::board {

template <class Word, int count>
struct Several {
  Word word[static_cast<size_t>(count)];
};

template <class Word>
struct ValueAndSlope {
  Word value;
  Word slope;
};

namespace detail {

// Arguments and results as the words of a measured loop's memory.
template <class T>
struct WordsOf {
  using Word = T;
  static constexpr int count = 1;
  static T load(const volatile Word* words) { return words[0]; }
  static void store(volatile Word* words, T value) { words[0] = value; }
};
template <class W>
struct WordsOf<ValueAndSlope<W>> {
  using Word = W;
  static constexpr int count = 2;
  static void store(volatile Word* words, const ValueAndSlope<W>& value) {
    words[0] = value.value;
    words[1] = value.slope;
  }
};
template <class W, int n>
struct WordsOf<Several<W, n>> {
  using Word = W;
  static constexpr int count = n;
  // Not loops: compilers keep them.
  template <int i = 0>
  static void load_from(const volatile Word* words, Several<W, n>& value) {
    value.word[i] = words[i];
    if constexpr (i + 1 < n) load_from<i + 1>(words, value);
  }
  static Several<W, n> load(const volatile Word* words) {
    Several<W, n> value;
    load_from(words, value);
    return value;
  }
  template <int i = 0>
  static void store(volatile Word* words, const Several<W, n>& value) {
    words[i] = value.word[i];
    if constexpr (i + 1 < n) store<i + 1>(words, value);
  }
};

// A loop's memory: the compiler can neither drop the kernel nor move it out of the loop.
template <class Argument, class Result>
struct Cells {
  volatile typename WordsOf<Argument>::Word argument[static_cast<size_t>(WordsOf<Argument>::count)];
  volatile typename WordsOf<Result>::Word result[static_cast<size_t>(WordsOf<Result>::count)];
};

// The kernel that does nothing: copies the first word of its argument to all of its result.
template <class Result, class Argument>
Result copied(const Argument& argument) {
  using Word = typename WordsOf<Result>::Word;
  if constexpr (WordsOf<Argument>::count == 1) {
    const Word word = static_cast<Word>(argument);
    if constexpr (WordsOf<Result>::count == 1) return word;
    else return {word, word};
  } else {
    const Word word = argument.word[0];
    if constexpr (WordsOf<Result>::count == 1) {
      return word;
    } else {
      Result result;
      for (Word& each : result.word) each = word;
      return result;
    }
  }
}

template <class Argument, class Kernel>
[[gnu::noipa]] uint32_t loop_instructions(Kernel kernel, Argument argument, uint32_t repetitions) {
  static_assert(__is_class(Kernel),
                "a pointer to a function would be called through the pointer: use a lambda");
  using Result = decltype(kernel(argument));
  static Cells<Argument, Result> cells;
  WordsOf<Argument>::store(cells.argument, argument);
  start_instruction_count();
  for (uint32_t left = repetitions; left != 0; --left) {
    WordsOf<Result>::store(cells.result, kernel(WordsOf<Argument>::load(cells.argument)));
  }
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
  const auto copy = [](Argument argument) { return detail::copied<Result>(argument); };
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
