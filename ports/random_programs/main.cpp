// Random programs of every operation against their budgets on this core: no query may take more instructions than the budget
// says, and half of all programs must have a query that takes 85 % of it or more.
#include <random_programs/composition.hpp>
#include <random_programs/queries.hpp>

namespace {

using namespace nearfield;
using namespace nearfield::costs;

constexpr uint32_t kPrograms = 1000;
constexpr uint32_t kFirstSeed = 20261122;
constexpr uint32_t kLeastMedianPermille = 850;

void write_fact(const char* label, uint32_t number, const char* after = "\n") {
  board::write(label);
  board::write_decimal(number);
  board::write(after);
}

// Worst measured over budget, of all programs that have this query.
struct Ratios {
  const char* name;
  uint16_t permille[kPrograms];
  uint32_t count = 0, exceeded = 0;

  void note(uint32_t seed, const Worst& worst) {
    uint32_t at = count++;
    const auto ratio = static_cast<uint16_t>(uint64_t{worst.measured} * 1000 / worst.budget);
    for (; at > 0 && permille[at - 1] > ratio; --at) permille[at] = permille[at - 1];
    permille[at] = ratio;
    if (worst.measured <= worst.budget) return;
    ++exceeded;
    write_fact("program ", seed, ", ");
    board::write(name);
    write_fact(": ", worst.measured, " instructions");
    write_fact(", budget ", worst.budget);
  }
  // One row; false if it is not as it should be.
  bool report() const {
    board::write_padded(name, 18);
    board::write_right_aligned(count, 9);
    board::write_right_aligned(exceeded, 10);
    board::write_right_aligned(permille[count / 2], 9);
    board::write_right_aligned(permille[0], 8);
    board::write_right_aligned(permille[count - 1], 8);
    const bool loose = permille[count / 2] < kLeastMedianPermille;
    board::write(exceeded != 0 ? "  EXCEEDED\n" : loose ? "  LOOSE\n" : "\n");
    return exceeded == 0 && !loose;
  }
};
Ratios values = {"value", {}}, clearances = {"clearance", {}}, soft_clearances = {"soft clearance", {}};

uint32_t uses[256];
void note_operations(const ProgramBuilder& image) {
  const uint32_t* words = image.words();
  for (uint32_t at = image_format::header_words + words[image_format::table_words]; at < image.size();) {
    ++uses[words[at] & 0xffu];
    at += 1 + (words[at] >> 8);
  }
}
bool is_used(uint32_t code) {
  if (uses[code] == 0) write_fact("no program has operation ", code);
  return uses[code] != 0;
}
bool all_operations_used() {
  bool all = true;
#define NEARFIELD_USED(code, ...) all = is_used(code) && all;
  NEARFIELD_OPERATIONS(NEARFIELD_USED)
  NEARFIELD_FRAME_OPERATIONS(NEARFIELD_USED)
#undef NEARFIELD_USED
  return all;
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  board::write("random programs on " NEARFIELD_CORE ", GCC " __VERSION__ "\n");
  uint32_t loaded_programs = 0, refused = 0, nodes = 0;
  for (uint32_t seed = kFirstSeed; loaded_programs < kPrograms; ++seed) {
    const Composition composition(seed);
    const Program<Q> program = load<Q>(composition.image().words(), composition.image().size() * 4);
    if (!program.valid()) {
      ++refused;
      continue;
    }
    ++loaded_programs;
    nodes += composition.nodes();
    note_operations(composition.image());
    Queries queries(program, seed);
    values.note(seed, queries.worst_value());
    if (program.kind() == Kind::distance) clearances.note(seed, queries.worst_clearance());
    if (queries.may_be_soft()) soft_clearances.note(seed, queries.worst_soft_clearance());
  }
  write_fact("seeds from ", kFirstSeed, ", ");
  write_fact("", loaded_programs, " programs of ");
  write_fact("", nodes / kPrograms, " operations on average, ");
  write_fact("", refused, " refused\n");
  board::write("worst in thousandths of the budget: programs, exceeded, median, least, greatest\n");
  bool good = values.report();
  good = clearances.report() && good;
  good = soft_clearances.report() && good;
  return good && all_operations_used() ? 0 : 1;
}
