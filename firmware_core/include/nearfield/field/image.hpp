// Program images: a field as data, checked in place once and then evaluated without any further check.
// Format: SPEC.md, "Images". Little-endian 32-bit words; position-independent; may lie in flash.
#pragma once

#include <nearfield/field/operations.hpp>
#include <nearfield/field/slots.hpp>

namespace nearfield {

enum class LoadStatus : uint8_t {
  ok,
  no_image,            // null pointer, not aligned to 4 bytes, or shorter than a header
  wrong_magic,         // not an image, or one of the other byte order
  wrong_version,
  wrong_size,          // truncated, or section sizes that do not add up
  crc_mismatch,
  wrong_scalar,        // made for another number type
  bad_table,           // segment count, headroom, coefficients that could overflow, or facts that do not hold
  unknown_operation,   // or one that the loader was built without
  truncated_operation,
  bad_table_reference,
  kind_mismatch,       // an operand of the wrong kind, or a program that does not end with exactly one result
  stack_too_deep,
  frames_unbalanced,
  frames_too_deep,
  parameter_out_of_range,
  certificate_mismatch,  // the image claims another certificate or depth than its contents have
};

namespace image_format {

inline constexpr uint32_t magic = 0x3149464eu;  // "NFI1"
inline constexpr uint32_t version = 3;
enum Word : uint32_t {
  magic_word, version_word, size_word, crc_word, scalar_word, kind_word, table_words, program_words, stack_depth_word,
  frame_depth_word, slot_count_word, lipschitz_word, erosion_word, inflation_word, error_word, header_words
};
// A table: index_bits, slope_headroom, the six facts, then 4 coefficients for each of 2^index_bits segments.
inline constexpr uint32_t table_header_words = 8;
inline constexpr uint32_t greatest_index_bits = 8;

}  // namespace image_format

inline constexpr int kStackDepth = 18;  // results waiting to be blended: an I-patch of eight sides has two for each
inline constexpr int kFrameDepth = 4;   // nested frames
inline constexpr uint32_t kImageWordLimit = 1u << 20;

namespace detail {

// What four zero bits after `bits` make of a CRC: 64 bytes of flash save three quarters of the time.
struct CrcOfNibbles {
  uint32_t of[16];
};
constexpr CrcOfNibbles crc_of_nibbles() {
  CrcOfNibbles table{};
  for (uint32_t nibble = 0; nibble < 16; ++nibble) {
    uint32_t crc = nibble;
    for (int bit = 0; bit < 4; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    table.of[nibble] = crc;
  }
  return table;
}
inline constexpr CrcOfNibbles kCrcOfNibbles = crc_of_nibbles();

}  // namespace detail

// CRC-32 (IEEE 802.3, reflected) of the image's words except the one that holds it.
constexpr uint32_t image_crc(const uint32_t* words, uint32_t count) {
  uint32_t crc = 0xffffffffu;
  for (uint32_t i = 0; i < count; ++i) {
    if (i == image_format::crc_word) continue;
    crc ^= words[i];
    for (int nibble = 0; nibble < 8; ++nibble) crc = (crc >> 4) ^ detail::kCrcOfNibbles.of[crc & 15u];
  }
  return ~crc;
}

template <class T> constexpr uint32_t payload_words = __is_empty(T) ? 0 : static_cast<uint32_t>(sizeof(T) / 4);

namespace detail {

template <uint32_t count> struct Words { uint32_t word[count]; };

template <class T> constexpr T read_payload(const uint32_t* words) {
  if constexpr (payload_words<T> == 0) {
    return T{};
  } else {
    Words<payload_words<T>> copy{};
    for (uint32_t i = 0; i < payload_words<T>; ++i) copy.word[i] = words[i];
    return bits_as<T>(copy);
  }
}

}  // namespace detail

// What there is to know about a program, found by walking it once.
template <class S> struct Inspection {
  LoadStatus status = LoadStatus::ok;
  uint32_t at_word = 0;  // where it failed, counted from the image's start
  Kind kind = Kind::distance;
  Certificate<S> certificate;  // with frames_unbalanced: of the last result, within what was not left
  int stack_depth = 0;
  int frame_depth = 0;
  uint32_t slot_count = 0;
  uint32_t parameter_count = 0;
  Certificate<S> boxed;     // of the last algebraic field in a declared box; not valid if there was none
  bool has_highest = true;  // of an intensity: whether its greatest value in a ball can be told
};

namespace detail {

constexpr TableFacts read_facts(const uint32_t* table) {
  return {static_cast<int32_t>(table[2]), static_cast<int32_t>(table[3]), static_cast<int32_t>(table[4]),
          static_cast<int32_t>(table[5]), static_cast<int32_t>(table[6]), static_cast<int32_t>(table[7])};
}

// A table of an image, by its first word.
template <class S> constexpr TableView<S> table_of_image(const uint32_t* table) {
  return {table + image_format::table_header_words, static_cast<int>(table[0]), static_cast<int>(table[1])};
}

// The abstract machine: evaluates a program on certificates instead of values.
template <class S, class Operations> class Inspector {
 public:
  constexpr Inspector(const uint32_t* image, uint32_t first, uint32_t last, uint32_t tables_first)
      : image_(image), at_(first), last_(last), tables_first_(tables_first), tables_last_(first) {
    reach_[0] = domain_reach<S>();
  }

  constexpr Inspection<S> run() {
    while (at_ < last_ && result_.status == LoadStatus::ok) {
      result_.at_word = at_;
      const uint32_t word = image_[at_];
      payload_ = at_ + 1;
      at_ = payload_ + (word >> 8);
      if ((word >> 8) > last_ - payload_) return fail(LoadStatus::truncated_operation);
      step(static_cast<Operation>(word & 0xffu), word >> 8);
    }
    if (result_.status != LoadStatus::ok) return result_;
    if (frames_ != 0) {
      if (stack_ > 0) result_.certificate = certificates_[stack_ - 1];
      return fail(LoadStatus::frames_unbalanced);
    }
    if (stack_ != 1) return fail(LoadStatus::kind_mismatch);
    result_.kind = kinds_[0];
    result_.certificate = certificates_[0];
    if (!result_.certificate.valid) return fail(LoadStatus::parameter_out_of_range);
    return result_;
  }

 private:
  constexpr Inspection<S> fail(LoadStatus status) {
    result_.status = status;
    return result_;
  }

  constexpr void step(Operation operation, uint32_t words) {
    switch (operation) {
#define NEARFIELD_CASE(code, name, type) \
  case Operation::name:                                   \
    if constexpr (Operations::has(Operation::name)) return operate<type<S>>(words); \
    break;
      NEARFIELD_OPERATIONS(NEARFIELD_CASE)
#undef NEARFIELD_CASE
      case Operation::enter_pose: return enter_pose(words);
      case Operation::enter_slot: return enter_slot(words);
      case Operation::leave: return leave(words);
      case Operation::enter_box: return enter_box(words);
      case Operation::leave_box: return leave_box(words);
      case Operation::enter_scale:
        if constexpr (Operations::has(Operation::enter_scale)) return enter_scale(words);
        break;
      case Operation::leave_scale:
        if constexpr (Operations::has(Operation::enter_scale)) return leave_scale(words);
        break;
    }
    fail(LoadStatus::unknown_operation);
  }

  template <class T> constexpr bool payload_fits(uint32_t words) {
    constexpr uint32_t expected = payload_words<T> + (uses_table<T> ? 1u : 0u);
    if (words != expected) fail(LoadStatus::truncated_operation);
    return words == expected;
  }
  // The table that an operation refers to by its word offset: one that the table section really holds.
  template <class T> constexpr bool table_found() {
    const uint32_t reference = image_[payload_ + payload_words<T>];
    uint32_t table = tables_first_;
    while (table < tables_last_ && table != reference) table += image_format::table_header_words + (4u << image_[table]);
    table_ = table;
    if (table >= tables_last_) fail(LoadStatus::bad_table_reference);
    return table < tables_last_;
  }

  constexpr void push(Kind kind, const Certificate<S>& certificate) {
    if (stack_ == kStackDepth) {
      fail(LoadStatus::stack_too_deep);
      return;
    }
    kinds_[stack_] = kind;
    certificates_[stack_] = certificate;
    ++stack_;
    if (stack_ > result_.stack_depth) result_.stack_depth = stack_;
    if (!certificate.valid) fail(LoadStatus::parameter_out_of_range);
  }

  template <class T> constexpr void operate(uint32_t words) {
    if (!payload_fits<T>(words)) return;
    const T operation = read_payload<T>(image_ + payload_);
    if (!take_operands<T>(operation)) return;
    if constexpr (uses_table<T>) {
      if (!table_found<T>()) return;
      if (!table_fits(operation, table_of_image<S>(image_ + table_))) {
        fail(LoadStatus::bad_table);
        return;
      }
    }
    if constexpr (takes_parameter_of<T>) {
      if (operation.slot >= kParameterLimit) {
        fail(LoadStatus::parameter_out_of_range);
        return;
      }
      if (operation.slot >= result_.parameter_count) result_.parameter_count = operation.slot + 1;
    }
    result_.has_highest = result_.has_highest && passes_highest<T>;
    if constexpr (operand_count_of<T> == 0) {
      if constexpr (uses_table<T>) push(T::kind, operation.certificate(reach_[frames_], read_facts(image_ + table_)));
      else push(T::kind, operation.certificate(reach_[frames_]));
    } else {
      const TableFacts facts = uses_table<T> ? read_facts(image_ + table_) : TableFacts{};
      push(T::kind, certificate_of(operation, certificates_ + stack_, taken_, facts, reach_[frames_]));
    }
  }
  // Takes them off the stack, where their certificates stay until the next push.
  template <class T> constexpr bool take_operands(const T& operation) {
    int count = operand_count_of<T>;
    if constexpr (operand_count_of<T> == kAnyNumber) count = operation.operand_count();
    bool fit = count >= 0 && count <= stack_ - floor();
    for (int i = 0; fit && i < count; ++i) fit = kinds_[stack_ - 1 - i] == operand_kind_of<T>;
    if (!fit || (operand_count_of<T> == kAnyNumber && count < 1)) {
      fail(LoadStatus::kind_mismatch);
      return false;
    }
    stack_ -= count;
    taken_ = count;
    return true;
  }

  // Inside of what `operation` enters points are within `reach`.
  constexpr void enter(Operation operation, Reach<S> reach) {
    if (frames_ == kFrameDepth) {
      fail(LoadStatus::frames_too_deep);
      return;
    }
    entered_[frames_] = {operation, stack_, payload_};
    ++frames_;
    reach_[frames_] = reach;
    if (frames_ > result_.frame_depth) result_.frame_depth = frames_;
  }
  // Whether the payload has so many words.
  constexpr bool has_words(uint32_t words, uint32_t expected) {
    if (words != expected) fail(LoadStatus::truncated_operation);
    return words == expected;
  }
  // Ends what was entered last, if that is of `operation` and left exactly one result more than it found.
  constexpr bool left(Operation operation) {
    const bool balanced =
        frames_ != 0 && entered_[frames_ - 1].operation == operation && stack_ == entered_[frames_ - 1].floor + 1;
    if (balanced) --frames_;
    else fail(LoadStatus::frames_unbalanced);
    return balanced;
  }
  constexpr void enter_pose(uint32_t words) {
    if (!has_words(words, payload_words<Pose<S>>)) return;
    const Pose<S> pose = read_payload<Pose<S>>(image_ + payload_);
    if (!valid_pose(pose)) {
      fail(LoadStatus::parameter_out_of_range);
      return;
    }
    enter(Operation::enter_pose, inner_reach(reach_[frames_], pose.translation));
  }
  constexpr void enter_slot(uint32_t words) {
    if (!has_words(words, 1)) return;
    const uint32_t slot = image_[payload_];
    if (slot >= kSlotLimit) {
      fail(LoadStatus::parameter_out_of_range);
      return;
    }
    if (slot >= result_.slot_count) result_.slot_count = slot + 1;
    const S d = ScalarTraits<S>::domain();
    enter(Operation::enter_slot, inner_reach(reach_[frames_], Vector3<S>{d, d, d}));
  }
  constexpr void enter_box(uint32_t words) {
    if (!has_words(words, payload_words<Vector3<S>>)) return;
    // Of all points around if the half extents are not valid: leave_box refuses them.
    DeclaredBox<S> box;
    box.half = read_payload<Vector3<S>>(image_ + payload_);
    enter(Operation::enter_box, box.half_valid() ? box.reach() : inner_reach(reach_[frames_], Vector3<S>{}));
  }
  // What enter_box found, and one algebraic result more.
  constexpr void leave_box(uint32_t words) {
    if (!has_words(words, payload_words<DeclaredBox<S>>) || !left(Operation::enter_box)) return;
    if (kinds_[stack_ - 1] != DeclaredBox<S>::operand_kind) {
      fail(LoadStatus::kind_mismatch);
      return;
    }
    const DeclaredBox<S> box = read_payload<DeclaredBox<S>>(image_ + payload_);
    const uint32_t* entered = image_ + entered_[frames_].payload;
    for (uint32_t i = 0; i < payload_words<Vector3<S>>; ++i) {
      if (entered[i] != image_[payload_ + i]) {
        fail(LoadStatus::parameter_out_of_range);
        return;
      }
    }
    result_.boxed = certificates_[stack_ - 1];
    --stack_;
    push(DeclaredBox<S>::kind, box.certificate(result_.boxed, reach_[frames_]));
  }
  constexpr void leave(uint32_t words) {
    const bool at_slot = frames_ != 0 && entered_[frames_ - 1].operation == Operation::enter_slot;
    if (!has_words(words, 0) || !left(at_slot ? Operation::enter_slot : Operation::enter_pose)) return;
    Certificate<S>& top = certificates_[stack_ - 1];
    top = placed_certificate(top, kinds_[stack_ - 1], reach_[frames_ + 1], at_slot ? PoseOrigin::run_time : PoseOrigin::constant);
  }
  constexpr void enter_scale(uint32_t words) {
    if (!has_words(words, payload_words<UniformScale<S>> + 1)) return;
    const auto scale = read_payload<UniformScale<S>>(image_ + payload_);
    const Reach<S> inner = scale.valid() ? scale.reach(reach_[frames_]) : Reach<S>{ScalarTraits<S>::greatest()};
    if (inner.radius < ScalarTraits<S>::greatest()) enter(Operation::enter_scale, inner);
    else fail(LoadStatus::parameter_out_of_range);
  }
  // The kind must be the one that was announced.
  constexpr void leave_scale(uint32_t words) {
    if (!has_words(words, 0) || !left(Operation::enter_scale)) return;
    const uint32_t* entered = image_ + entered_[frames_].payload;
    const Kind kind = kinds_[stack_ - 1];
    if (entered[payload_words<UniformScale<S>>] != static_cast<uint32_t>(kind)) {
      fail(LoadStatus::kind_mismatch);
      return;
    }
    --stack_;
    push(kind, read_payload<UniformScale<S>>(entered).certificate(certificates_[stack_], kind, reach_[frames_]));
  }
  constexpr int floor() const { return frames_ == 0 ? 0 : entered_[frames_ - 1].floor; }

  const uint32_t* image_;
  uint32_t at_, last_, tables_first_, tables_last_;
  uint32_t payload_ = 0, table_ = 0;
  int stack_ = 0, frames_ = 0, taken_ = 0;
  Kind kinds_[kStackDepth] = {};
  Certificate<S> certificates_[kStackDepth] = {};
  Reach<S> reach_[kFrameDepth + 1] = {};
  struct Entered {
    Operation operation = Operation::enter_pose;
    int floor = 0;         // results that lay on the stack then
    uint32_t payload = 0;  // its place in the image
  };
  Entered entered_[kFrameDepth] = {};
  Inspection<S> result_;
};

// What Inspector finds; at run time by a function that is compiled once (program.hpp: NEARFIELD_PROGRAMS).
template <class S, class Operations>
Inspection<S> inspect_operations_at_run_time(const uint32_t* image, uint32_t first, uint32_t last) {
  return Inspector<S, Operations>(image, first, last, image_format::header_words).run();
}
template <class S, class Operations>
constexpr Inspection<S> inspect_operations(const uint32_t* image, uint32_t first, uint32_t last) {
  if (!__builtin_is_constant_evaluated()) return inspect_operations_at_run_time<S, Operations>(image, first, last);
  return Inspector<S, Operations>(image, first, last, image_format::header_words).run();
}

// Fills in the header of an image of `size` words, of which `tables` are tables, whose program was found to be this.
template <class S>
constexpr void write_header(uint32_t* image, uint32_t tables, uint32_t size, const Inspection<S>& found) {
  using namespace image_format;
  image[magic_word] = magic;
  image[version_word] = version;
  image[size_word] = size;
  image[scalar_word] = ScalarTraits<S>::tag;
  image[kind_word] = static_cast<uint32_t>(found.kind);
  image[table_words] = tables;
  image[program_words] = size - header_words - tables;
  image[stack_depth_word] = static_cast<uint32_t>(found.stack_depth);
  image[frame_depth_word] = static_cast<uint32_t>(found.frame_depth);
  image[slot_count_word] = found.slot_count;
  image[lipschitz_word] = static_cast<uint32_t>(found.certificate.lipschitz.raw());
  image[erosion_word] = ScalarTraits<S>::word(found.certificate.erosion);
  image[inflation_word] = ScalarTraits<S>::word(found.certificate.inflation);
  image[error_word] = ScalarTraits<S>::word(found.certificate.error);
  image[crc_word] = image_crc(image, size);
}

// Whether the kernel can run on a table of the image without leaving the number range, and its facts hold. What the
// coefficients cannot tell is facts.error: how far they are from the function that was meant.
template <class S> constexpr bool table_holds(const uint32_t* table) {
  if (table[1] > 3 || table[1] > table[0]) return false;
  const TableView<S> view = table_of_image<S>(table);
  const int segments = 1 << view.index_bits;
  if (!coefficients_in_range(view, segments)) return false;
  const TableFacts claimed = read_facts(table), found = ranges_of(view, segments);
  return claimed.error >= 0 && claimed.slope_error >= 0 && claimed.least_value <= found.least_value && claimed.greatest_value >= found.greatest_value &&
         claimed.least_slope <= found.least_slope && claimed.greatest_slope >= found.greatest_slope;
}

}  // namespace detail

// Checks an image of `word_count` words completely: after `ok` no evaluation can fail, overflow or read outside it.
// Time: bounded, about 320 instructions a word on Cortex-M4 (the CRC, tables and operations).
template <class S, class Operations = AllOperations>
constexpr Inspection<S> inspect_image(const uint32_t* words, uint32_t word_count) {
  using namespace image_format;
  Inspection<S> failed;
  const auto fail = [&failed](LoadStatus status, uint32_t at) {
    failed.status = status;
    failed.at_word = at;
    return failed;
  };
  if (words == nullptr || word_count < header_words) return fail(LoadStatus::no_image, 0);
  if (words[magic_word] != magic) return fail(LoadStatus::wrong_magic, magic_word);
  if (words[version_word] != version) return fail(LoadStatus::wrong_version, version_word);
  const uint32_t size = words[size_word];
  if (size > word_count || size > kImageWordLimit || size < header_words) return fail(LoadStatus::wrong_size, size_word);
  if (words[table_words] > size - header_words || words[program_words] != size - header_words - words[table_words]) {
    return fail(LoadStatus::wrong_size, table_words);
  }
  if (words[crc_word] != image_crc(words, size)) return fail(LoadStatus::crc_mismatch, crc_word);
  if (words[scalar_word] != ScalarTraits<S>::tag) return fail(LoadStatus::wrong_scalar, scalar_word);

  const uint32_t tables_last = header_words + words[table_words];
  for (uint32_t table = header_words; table < tables_last;) {
    if (tables_last - table < table_header_words || words[table] > greatest_index_bits ||
        tables_last - table - table_header_words < (4u << words[table]) || !detail::table_holds<S>(words + table)) {
      return fail(LoadStatus::bad_table, table);
    }
    table += table_header_words + (4u << words[table]);
  }
  const Inspection<S> found = detail::inspect_operations<S, Operations>(words, tables_last, size);
  if (found.status != LoadStatus::ok) return found;
  if (words[kind_word] != static_cast<uint32_t>(found.kind) ||
      words[stack_depth_word] != static_cast<uint32_t>(found.stack_depth) ||
      words[frame_depth_word] != static_cast<uint32_t>(found.frame_depth) ||
      words[slot_count_word] != found.slot_count ||
      words[lipschitz_word] != static_cast<uint32_t>(found.certificate.lipschitz.raw()) ||
      words[erosion_word] != ScalarTraits<S>::word(found.certificate.erosion) ||
      words[inflation_word] != ScalarTraits<S>::word(found.certificate.inflation) ||
      words[error_word] != ScalarTraits<S>::word(found.certificate.error)) {
    return fail(LoadStatus::certificate_mismatch, kind_word);
  }
  return found;
}

}  // namespace nearfield
