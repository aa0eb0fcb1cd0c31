#include "curves/curve_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string_view>

#include "text/number.hpp"

namespace nearfield::host {
namespace {

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...) {
  char buffer[256];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return {buffer, static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(sizeof buffer) - 1))};
}

std::string fact(const char* name, const std::string& text) {
  return formatted("  %-15s", name) + text + "\n";
}

std::string six_digits(double value) { return formatted("%.6g", value); }

std::string slope_error_in_words(const StudiedTable& table, const char* argument) {
  if (table.slope_error >= 127.9) return "above 128 per unit of " + std::string(argument) + ", not stated";
  return "at most " + error_in_words(table.slope_error) + " per unit of " + argument +
         ", where there is a slope";
}

std::string smoothness(const CurveFacts& facts) {
  if (facts.continuous_derivatives < 0) {
    return facts.middle_jump > 0.0 ? "jumps in the middle of its range" : "jumps at the ends of its range";
  }
  if (facts.continuous_derivatives >= kInfinitelySmooth) return "C^infinity";
  return "C^" + std::to_string(facts.continuous_derivatives) +
         (facts.continuous_derivatives == 0 ? ", kinks in its slope" : "");
}

std::string order(int vanishing_derivatives) {
  if (vanishing_derivatives <= 0) return "0: no derivative need vanish at the ends of the range";
  if (vanishing_derivatives == 1) return "1: the first derivative vanishes at both ends of the range";
  return std::to_string(vanishing_derivatives) + ": that many derivatives vanish at both ends of the range";
}

std::string symmetry(const CurveFacts& facts) {
  const std::string middle = format_number(facts.middle()),
                    half = format_number(0.5 * (facts.before + facts.after));
  if (facts.antisymmetric) return "antisymmetric about (" + middle + ", " + half + ")";
  if (facts.centred) return "none, but centred: " + half + " at " + middle;
  return "none, and not centred";
}

std::string pairs(const ControlPoints& points) {
  std::string text;
  for (int i = 0; i < points.count; ++i) {
    text +=
        std::string(i > 0 ? " " : "") + "(" + six_digits(points.x[i]) + ", " + six_digits(points.y[i]) + ")";
  }
  return text;
}

std::string break_places(const CurveFacts& facts) {
  std::string text;
  for (int i = 0; i < facts.break_count; ++i) {
    text += (i > 0 ? ", " : "") + six_digits(facts.from + facts.breaks[i] * (facts.to - facts.from));
  }
  return text;
}

std::string facts_of_curve(const CurveStudy& study) {
  const CurveFacts facts = study.curve().facts();
  std::string text = headline_of(study) + "\n";
  text += fact("family", study.configured.family == CurveFamily::step ? "unit step" : "potential");
  text += fact("range", std::string(study.argument_name()) + " from " + format_number(facts.from) + " to " +
                            format_number(facts.to) + "; below it " + format_number(facts.before) +
                            ", above it " + format_number(facts.after));
  text += fact("direction", facts.direction == Direction::rising    ? "rising"
                            : facts.direction == Direction::falling ? "falling"
                                                                    : "not known to be monotone");
  text += fact("smoothness", smoothness(facts));
  text += fact("order", order(facts.vanishing_derivatives));
  text += fact("symmetry", symmetry(facts));
  if (facts.end_jump > 0.0)
    text += fact("jump", "up to " + six_digits(facts.end_jump) + " at an end of the range");
  if (facts.middle_jump > 0.0) {
    text += fact("jump", six_digits(2.0 * facts.middle_jump) + " at " + format_number(facts.middle()));
  }
  if (facts.break_count > 0) text += fact("pieces meet at", break_places(facts));
  const ControlPoints points = study.curve().control_points();
  if (points.count > 0) text += fact("control points", pairs(points));
  return text;
}

std::string facts_of_table(const CurveStudy& study) {
  std::string text;
  const std::string missed = missed_error_of(study);
  if (!missed.empty()) text += missed + "\n";
  if (!study.table) return text;
  const StudiedTable& table = *study.table;
  text += fact("table", type_name(study.scalar) + ", degree " + std::to_string(table.shape.degree) + ", " +
                            std::to_string(table.shape.segments) +
                            (table.shape.segments == 1 ? " segment" : " segments"));
  text += fact("bytes", std::to_string(table.shape.bytes()) + ", coefficients of " +
                            std::to_string(table.shape.bits) + " bits");
  text += fact("argument",
               std::string(study.argument_name()) + (table.shape.over_square ? "^2" : "") +
                   (table.mirrored ? ", upper half of the range, the lower mirrored" : ", all of the range"));
  text += fact("error", "at most " + error_in_words(table.error));
  text += fact("slope error", slope_error_in_words(table, study.argument_name()));
  return text;
}

std::string samples_of(const CurveStudy& study, int count) {
  std::string text = formatted("%10s %12s", study.argument_name(), "exact");
  text += study.table ? formatted(" %12s %9s %12s %12s %9s\n", "table", "error", "exact slope", "table slope",
                                  "error")
                      : formatted(" %12s\n", "exact slope");
  for (const CurveRow& row : rows_of(study, count)) {
    text += formatted("%10.7f %12.9f", row.argument, row.exact.value);
    text += row.table ? formatted(" %12.9f %9.1e %12.6f %12.6f %9.1e\n", row.table->value, row.error(),
                                  row.exact.first, row.table->slope, row.slope_error())
                      : formatted(" %12.6f\n", row.exact.first);
  }
  return text;
}

// One line of the list: name, what is allowed, default, meaning.
struct ListedParameter {
  std::string name, allowed, initial, meaning;
};

ListedParameter listed(const CurveParameter& parameter) {
  return {parameter.name, allowed_values(parameter),
          "default " + settable_text(parameter.initial, parameter.initial_count), parameter.meaning};
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 2, width + 2), ' ');
  return text;
}

}  // namespace

std::string headline_of(const CurveStudy& study) {
  return study.configured.name +
         (study.configured.parameters.empty() ? "" : ", " + study.configured.parameters);
}

std::string table_in_words(const CurveStudy& study) {
  if (!study.table) return "no table";
  const TableShape& shape = study.table->shape;
  return "degree " + std::to_string(shape.degree) + ", " + std::to_string(shape.segments) +
         (shape.segments == 1 ? " segment" : " segments") + " over " + study.argument_name() +
         (shape.over_square ? "^2" : "") + ", " + std::to_string(shape.bytes()) + " bytes";
}

std::string error_in_words(double error) {
  return error > 0.0 ? formatted("%.3g = 2^%.2f", error, std::log2(error)) : "0";
}

std::string missed_error_of(const CurveStudy& study) {
  const std::string table =
      study.request.segments != 0
          ? "no table of " + std::to_string(study.request.segments) + " segments"
          : "no table of at most " + std::to_string(study.request.greatest_bytes) + " bytes";
  if (!study.table) return table + " can hold this curve";
  if (study.within_error) return "";
  return table + " comes within 2^-" + std::to_string(study.request.log2_error) + "; the best reaches " +
         error_in_words(study.table->error);
}

std::string text_report_of(const CurveStudy& study, int count) {
  return facts_of_curve(study) + "\n" + facts_of_table(study) + "\n" + samples_of(study, count);
}

std::string csv_report_of(const CurveStudy& study, int count) {
  std::string text =
      "argument,exact,table,error,exact_slope,table_slope,slope_error,exact_second_derivative\n";
  for (const CurveRow& row : rows_of(study, count)) {
    const auto of_table = [&row](double value) { return "," + (row.table ? format_number(value) : ""); };
    text += format_number(row.argument) + "," + format_number(row.exact.value);
    text += of_table(row.table ? row.table->value : 0.0) + of_table(row.error());
    text += "," + format_number(row.exact.first);
    text += of_table(row.table ? row.table->slope : 0.0) + of_table(row.slope_error());
    text += "," + format_number(row.exact.second) + "\n";
  }
  return text;
}

std::string list_of_curves() {
  struct Block {
    std::string title;
    std::vector<ListedParameter> parameters;
  };
  std::vector<Block> blocks;
  std::size_t name_width = 0, title_width = 0, allowed_width = 0, initial_width = 0;
  const auto add = [&](const std::string& title, const std::vector<CurveParameter>& parameters) {
    Block& block = blocks.emplace_back();
    block.title = title;
    for (const CurveParameter& parameter : parameters) {
      const ListedParameter& one = block.parameters.emplace_back(listed(parameter));
      name_width = std::max(name_width, one.name.size());
      allowed_width = std::max(allowed_width, one.allowed.size());
      initial_width = std::max(initial_width, one.initial.size());
    }
  };
  for (const CatalogueEntry& entry : curve_catalogue())
    title_width = std::max(title_width, entry.name.size());
  for (const CatalogueEntry& entry : curve_catalogue()) {
    add(padded(std::string(entry.name), title_width) +
            (entry.family == CurveFamily::step ? "step" : "potential") +
            (entry.parameters.empty() ? ", no parameters" : ""),
        entry.parameters);
  }
  add("every potential besides", range_control_parameters());
  std::string text;
  for (const Block& block : blocks) {
    text += (text.empty() ? "" : "\n") + block.title + "\n";
    for (const ListedParameter& one : block.parameters) {
      text += "  " + padded(one.name, name_width) + padded(one.allowed, allowed_width) +
              padded(one.initial, initial_width) + one.meaning + "\n";
    }
  }
  return text;
}

}  // namespace nearfield::host
