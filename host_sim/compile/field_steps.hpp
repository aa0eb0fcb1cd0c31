// What a field is made of, and the program image that holds it.
#pragma once

#include <cstdint>
#include <vector>

#include <nearfield/field/image.hpp>

#include "compile/table_baker.hpp"
#include "model/field_node.hpp"

namespace nearfield::host {

// One operation. `words`: its payload as the image has it, for the scalar that the field is made for; of
// operations with a table, its reference comes last.
struct FieldStep {
  const FieldNode* node = nullptr;  // to blame for it
  Operation operation = Operation::leave;
  std::vector<std::uint32_t> words;
};

// The reference by which operations name the table at `index`.
std::uint32_t table_reference(const std::vector<ImageTable>& tables, std::size_t index);

// The index of the step that has an image's word at `word`; the last one when all are before it.
std::size_t step_at(const std::vector<ImageTable>& tables, const std::vector<FieldStep>& steps,
                    std::uint32_t word);

template <class S>
struct CompiledField {
  std::vector<std::uint32_t> image;
  nearfield::Inspection<S> inspection;  // status ok, unless something else is said
};

// The image of tables and steps. Its status says whether a loader takes it.
template <class S>
CompiledField<S> write_image(const std::vector<ImageTable>& tables, const std::vector<FieldStep>& steps);

}  // namespace nearfield::host
