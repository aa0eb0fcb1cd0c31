#include "compile/field_steps.hpp"

// Declares what compile/programs_of_*.cpp compile: the check of a program.
#include <nearfield/field/program.hpp>

namespace nearfield::host {
namespace {

constexpr std::size_t largest_image = std::size_t{1} << 16U;  // words

std::uint32_t words_of(const ImageTable& table) {
  return image_format::table_header_words + static_cast<std::uint32_t>(table.coefficients.size());
}

void append(std::vector<std::uint32_t>& image, const ImageTable& table) {
  const TableFacts& facts = table.facts;
  for (const std::int32_t number :
       {std::int32_t{table.index_bits}, std::int32_t{table.slope_headroom}, facts.error, facts.slope_error,
        facts.least_value, facts.greatest_value, facts.least_slope, facts.greatest_slope}) {
    image.push_back(static_cast<std::uint32_t>(number));
  }
  image.insert(image.end(), table.coefficients.begin(), table.coefficients.end());
}

void append(std::vector<std::uint32_t>& image, const FieldStep& step) {
  image.push_back(static_cast<std::uint32_t>(step.operation) | static_cast<std::uint32_t>(step.words.size())
                                                                   << 8U);
  image.insert(image.end(), step.words.begin(), step.words.end());
}

template <class S>
nearfield::Inspection<S> failed(LoadStatus status, std::uint32_t word) {
  nearfield::Inspection<S> inspection;
  inspection.status = status;
  inspection.at_word = word;
  return inspection;
}

// Fills in the header of an image with `table_size` words of tables.
template <class S>
nearfield::Inspection<S> finish(std::vector<std::uint32_t>& image, std::uint32_t table_size) {
  using namespace image_format;
  const std::uint32_t first = header_words + table_size, last = static_cast<std::uint32_t>(image.size());
  for (std::uint32_t table = header_words; table < first;
       table += table_header_words + (4U << image[table])) {
    if (!nearfield::detail::table_holds<S>(image.data() + table))
      return failed<S>(LoadStatus::bad_table, table);
  }
  const auto found =
      nearfield::detail::inspect_operations_at_run_time<S, AllOperations>(image.data(), first, last);
  nearfield::detail::write_header(image.data(), table_size, last, found);
  return found;
}

}  // namespace

std::uint32_t table_reference(const std::vector<ImageTable>& tables, std::size_t index) {
  std::uint32_t reference = image_format::header_words;
  for (std::size_t i = 0; i < index; ++i) reference += words_of(tables[i]);
  return reference;
}

std::size_t step_at(const std::vector<ImageTable>& tables, const std::vector<FieldStep>& steps,
                    std::uint32_t word) {
  std::size_t start = table_reference(tables, tables.size());
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    start += 1 + steps[i].words.size();
    if (word < start) return i;
  }
  return steps.empty() ? 0 : steps.size() - 1;
}

template <class S>
CompiledField<S> write_image(const std::vector<ImageTable>& tables, const std::vector<FieldStep>& steps) {
  CompiledField<S> field;
  field.image.resize(image_format::header_words);
  for (const ImageTable& table : tables) append(field.image, table);
  const auto table_size = static_cast<std::uint32_t>(field.image.size()) - image_format::header_words;
  for (const FieldStep& step : steps) append(field.image, step);
  field.inspection = field.image.size() > largest_image ? failed<S>(LoadStatus::wrong_size, 0)
                                                        : finish<S>(field.image, table_size);
  return field;
}

template CompiledField<Fixed<27>> write_image(const std::vector<ImageTable>&, const std::vector<FieldStep>&);
template CompiledField<Fixed<24>> write_image(const std::vector<ImageTable>&, const std::vector<FieldStep>&);
template CompiledField<Fixed<16>> write_image(const std::vector<ImageTable>&, const std::vector<FieldStep>&);
template CompiledField<float> write_image(const std::vector<ImageTable>&, const std::vector<FieldStep>&);

}  // namespace nearfield::host
