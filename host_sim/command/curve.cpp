#include <cstdio>

#include "command/command.hpp"
#include "command/drawing.hpp"
#include "command/options.hpp"
#include "curves/curve_drawing.hpp"
#include "curves/curve_report.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/number.hpp"
#include "text/read_file.hpp"

namespace nearfield::host {
namespace {

constexpr int greatest_byte_count = 16384;
constexpr int greatest_segment_count = 1024;
constexpr int samples_of_text = 11;
constexpr int samples_of_csv = 101;

// A whole number given with an option, or `initial`.
int whole_number(const Options& options, const std::string& name, int least, int greatest, int initial) {
  const auto text = options.value(name);
  if (!text) return initial;
  const auto number = parse_number(*text);
  if (!number || !(*number >= least && *number <= greatest) || *number != static_cast<int>(*number)) {
    throw UsageError("--" + name + " " + *text + " is not a whole number from " + std::to_string(least) +
                     " to " + std::to_string(greatest));
  }
  return static_cast<int>(*number);
}

// One of the names that an option allows, as a number; 0 is what it is without the option.
std::size_t choice(const Options& options, const std::string& name,
                   const std::vector<std::string_view>& allowed) {
  const auto text = options.value(name);
  if (!text) return 0;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (allowed[i] == *text) return i;
  }
  throw UsageError("--" + name + ": " + unknown_name("name", *text, allowed) + ": it is one of " +
                   joined(allowed));
}

CurveScalar scalar_of(const Options& options) {
  constexpr CurveScalar scalars[] = {CurveScalar::q27, CurveScalar::q24, CurveScalar::q16,
                                     CurveScalar::single};
  return scalars[choice(options, "scalar", {"q27", "q24", "q16", "float"})];
}

TableRequest request_of(const Options& options) {
  constexpr TableParameter parameters[] = {TableParameter::automatic, TableParameter::direct,
                                           TableParameter::squared};
  TableRequest request;
  request.log2_error = whole_number(options, "error", 0, 30, 20);
  request.greatest_bytes = whole_number(options, "bytes", 4, greatest_byte_count, 1024);
  request.degree = whole_number(options, "degree", 1, 3, 0);
  request.segments = whole_number(options, "segments", 1, greatest_segment_count, 0);
  request.bits = whole_number(options, "bits", 16, 32, 32);
  request.parameter = parameters[choice(options, "argument", {"automatic", "r", "square"})];
  if (request.bits != 16 && request.bits != 32) {
    throw UsageError("--bits " + std::to_string(request.bits) + " is neither 16 nor 32");
  }
  if (request.bits == 16 && scalar_of(options) == CurveScalar::single) {
    throw UsageError("--bits 16 goes with fixed point, not with --scalar float");
  }
  if (request.segments != 0 && options.has("bytes"))
    throw UsageError("--segments and --bytes exclude each other");
  if (request.degree == 2 && request.segments % 2 != 0) {
    throw UsageError("--segments " + std::to_string(request.segments) +
                     " is odd: pieces of degree 2 come in pairs");
  }
  return request;
}

void check_table(const CurveStudy& study, const Options& options) {
  const CurveFacts facts = study.curve().facts();
  if (study.request.parameter == TableParameter::squared && facts.from != 0.0) {
    throw UsageError("--argument square is for curves whose range starts at 0: potentials");
  }
  if (options.has("error") && !study.within_error) {
    throw InputError("nearfield curve", {}, study.configured.name, missed_error_of(study), "");
  }
}

// What is printed after the name of a file.
std::string said_of(const CurveStudy& study) {
  std::string said = headline_of(study);
  if (study.table) {
    said += "; table of " + table_in_words(study) + ", error at most " + error_in_words(study.table->error);
  }
  const std::string missed = missed_error_of(study);
  return missed.empty() ? said : said + "\n" + missed;
}

void write(const std::string& file, const std::string& text, const std::string& said) {
  if (file == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  write_file(file, text);
  std::printf("%s: %s\n", file.c_str(), said.c_str());
}

void print_help() {
  std::printf(
      "usage: nearfield curve NAME [--set NAME=VALUE]... [--csv FILE | --svg FILE] [OPTION...]\n"
      "       nearfield curve --list\n\n"
      "A unit step or a potential function beside its table: exact value, table value, slopes and "
      "errors.\n\n%s",
      describe(curve_options()).c_str());
}

CurveStudy checked_study_of(const Options& options) {
  if (!options.operand()) {
    throw InputError("nearfield curve", {}, "", "which curve?", "`nearfield curve --list` names them all");
  }
  if (options.has("csv") && options.has("svg")) throw UsageError("--csv and --svg exclude each other");
  if (options.has("svg") && options.has("samples"))
    throw UsageError("--samples is for text and --csv; pictures have their own");
  if (options.has("rising-range") && !options.has("svg")) throw UsageError("--rising-range goes with --svg");
  const TableRequest request = request_of(options);
  const ConfiguredCurve configured = configured_curve(*options.operand(), options.values("set"));
  const CurveStudy study = study_of(configured, request, scalar_of(options));
  check_table(study, options);
  return study;
}

double rising_range_of(const Options& options, const CurveStudy& study) {
  const auto text = options.value("rising-range");
  if (!text) return 1.0;
  const auto number = parse_number(*text);
  if (!number || !(*number >= 0.02 && *number <= 1.0))
    throw UsageError("--rising-range " + *text + ": a number from 0.02 to 1");
  if (study.configured.family != CurveFamily::step)
    throw UsageError("--rising-range is of steps; " + study.configured.name + " is a potential");
  return *number;
}

}  // namespace

std::vector<OptionDescription> curve_options() {
  return {
      {"set", "NAME=VALUE", "a parameter of the curve; lists with commas: b=1,1,0,0", true},
      {"list", "", "name every curve with its parameters, their ranges and defaults"},
      {"csv", "FILE", "write samples as comma-separated values; -: to standard output"},
      {"svg", "FILE", "draw the curve, its derivatives, control points and the table's error; - as above"},
      {"rising-range", "E", "of a step in its picture, 0.02 to 1: t / E instead of t; default: 1"},
      {"samples", "N", "how many samples, 2 to 100001; default: 11, with --csv 101; pictures have their own"},
      {"error", "BITS",
       "refuse tables that err by more than 2^-BITS, 1 to 30; 0: the best; default: 20 if possible"},
      {"bytes", "N", "greatest size of the table, 4 to 16384; default: 1024"},
      {"degree", "N", "of the table's pieces: 1, 2 or 3; default: chosen"},
      {"segments", "N", "of the table, 1 to 1024, instead of --bytes; default: chosen"},
      {"bits", "N", "of a coefficient: 32 or 16; default: 32"},
      {"argument", "NAME", "of the table: r, square (r^2) or automatic; default: automatic"},
      {"scalar", "NAME", "number type of the table: q27, q24, q16 or float; default: q27"},
      {"help", "", "this text"}};
}

Drawing draw_curve(const Options& options, const ReportProgress&) {
  if (options.has("list")) throw UsageError("--list goes without a name and without other options");
  const CurveStudy study = checked_study_of(options);
  options.required("svg");
  return {draw::curve_picture_svg(picture_of(study, rising_range_of(options, study))), said_of(study), ""};
}

int run_curve(const std::vector<std::string>& arguments) {
  const Options options(curve_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  if (options.has("list")) {
    if (arguments.size() > 1) throw UsageError("--list goes without a name and without other options");
    std::printf("%s", list_of_curves().c_str());
    return 0;
  }
  if (options.has("svg")) {
    const Drawing drawing = draw_curve(options, {});
    write(options.required("svg"), drawing.bytes, drawing.said);
    return 0;
  }
  const CurveStudy study = checked_study_of(options);
  const auto csv = options.value("csv");
  const int samples = whole_number(options, "samples", 2, 100001, csv ? samples_of_csv : samples_of_text);
  if (csv) {
    write(*csv, csv_report_of(study, samples), said_of(study));
  } else {
    write("-", text_report_of(study, samples), "");
  }
  return 0;
}

}  // namespace nearfield::host
