// `nearfield curve`: its list, its reports and its pictures.
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "command_runner.hpp"
#include "curves/curve_settings.hpp"
#include "text/number.hpp"
#include "unit/draw/well_formed.hpp"

namespace nearfield::host {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class CurveCommand : public testing::Test {
 protected:
  // What the command prints when all is well.
  std::string curve(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "curve");
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.status, 0) << typed(arguments);
    EXPECT_EQ(outcome.err, "") << typed(arguments);
    return outcome.out;
  }

  ScratchFolder folder_;
};

// The stated greatest error in a report or a summary.
double stated_error(const std::string& text) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex("error +at most ([0-9.e+-]+)"))) return -1.0;
  return parse_number(match[1].str()).value_or(-1.0);
}

struct CsvRow {
  double argument, exact, table, error, exact_slope, table_slope, slope_error, second;
};

// Fails the test unless it is the header and rows of eight numbers.
std::vector<CsvRow> parsed_csv(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<CsvRow> rows;
  if (lines.empty()) {
    ADD_FAILURE() << "nothing";
    return rows;
  }
  EXPECT_EQ(lines[0],
            "argument,exact,table,error,exact_slope,table_slope,slope_error,exact_second_derivative");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<double> numbers;
    std::istringstream fields(lines[i]);
    for (std::string field; std::getline(fields, field, ',');) {
      const auto number = parse_number(field);
      if (!number) ADD_FAILURE() << lines[i];
      numbers.push_back(number.value_or(0.0));
    }
    if (numbers.size() != 8) {
      ADD_FAILURE() << lines[i];
      continue;
    }
    rows.push_back(
        {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], numbers[7]});
  }
  return rows;
}

TEST_F(CurveCommand, ListNamesEveryCurveWithItsParameters) {
  const std::vector<std::string> lines = lines_of(curve({"--list"}));
  std::size_t at = 0;
  const auto expect_parameter = [&](const CurveParameter& parameter) {
    ASSERT_LT(at, lines.size()) << parameter.name;
    const std::string& line = lines[at++];
    EXPECT_EQ(line.rfind("  " + std::string(parameter.name) + " ", 0), 0U) << line;
    EXPECT_NE(line.find("  " + allowed_values(parameter) + "  "), std::string::npos) << line;
    EXPECT_NE(line.find("  default " + settable_text(parameter.initial, parameter.initial_count) + "  "),
              std::string::npos)
        << line;
    EXPECT_NE(line.find(parameter.meaning), std::string::npos) << line;
  };
  for (const CatalogueEntry& entry : curve_catalogue()) {
    SCOPED_TRACE(std::string(entry.name));
    ASSERT_LT(at, lines.size());
    EXPECT_EQ(lines[at].rfind(std::string(entry.name) + " ", 0), 0U) << lines[at];
    EXPECT_NE(lines[at].find(entry.family == CurveFamily::step ? "  step" : "  potential"),
              std::string::npos);
    ++at;
    for (const CurveParameter& parameter : entry.parameters) expect_parameter(parameter);
    ASSERT_LT(at, lines.size());
    EXPECT_EQ(lines[at++], "");
  }
  ASSERT_LT(at, lines.size());
  EXPECT_EQ(lines[at++], "every potential besides");
  for (const CurveParameter& parameter : range_control_parameters()) expect_parameter(parameter);
  EXPECT_EQ(at, lines.size());
}

// What the list shows as a default may be set.
TEST_F(CurveCommand, DefaultsOfTheListChangeNothing) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    const std::string name(entry.name);
    std::vector<std::string> arguments = {name};
    for (const CurveParameter& parameter : entry.parameters) {
      arguments.push_back("--set");
      arguments.push_back(std::string(parameter.name) + "=" +
                          settable_text(parameter.initial, parameter.initial_count));
    }
    EXPECT_EQ(curve(arguments), curve({name})) << name;
  }
}

TEST_F(CurveCommand, ReportTellsFactsTableAndSamples) {
  const std::string text = curve({"arctangent", "--set", "c1=20"});
  EXPECT_EQ(text.rfind("arctangent, c1 = 20, c2 = 0.5\n", 0), 0U) << text;
  for (const char* part :
       {"family         potential\n", "range          r from 0 to 1; below it 1, above it 0\n",
        "direction      falling\n", "smoothness     jumps at the ends", "order          0",
        "symmetry       antisymmetric about (0.5, 0.5)\n", "jump           up to 0.0317255 at an end",
        "table          Fixed<27>, degree 3", "bytes          1024, coefficients of 32 bits\n",
        "the lower mirrored\n", "slope error    at most "}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) {
                            return std::regex_match(line, std::regex("( +[-+.e0-9]+){7}"));
                          }),
            11);
  EXPECT_GT(stated_error(text), 0.0);
  EXPECT_NE(curve({"heaviside"}).find("jump           1 at 0\n"), std::string::npos);
  EXPECT_NE(curve({"bezier"}).find("smoothness     C^2\n"), std::string::npos);
  EXPECT_NE(curve({"bezier"}).find("control points (0, 1) (0.2, 1) (0.4, 1) (0.6, 0) (0.8, 0) (1, 0)\n"),
            std::string::npos);
  EXPECT_NE(curve({"wyvill"}).find("argument       r^2, all of the range\n"), std::string::npos);
  EXPECT_NE(curve({"blanc"}).find("none, but centred: 0.5 at 0.5\n"), std::string::npos);
  EXPECT_NE(curve({"rising_cutoff"}).find("none, and not centred\n"), std::string::npos);
}

TEST_F(CurveCommand, ErrorsOfSamplesStayWithinWhatIsStated) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    const std::string name(entry.name);
    for (const char* scalar : {"q27", "q24", "q16", "float"}) {
      SCOPED_TRACE(name + " " + scalar);
      const double error = stated_error(curve({name, "--scalar", scalar}));
      const std::vector<CsvRow> rows =
          parsed_csv(curve({name, "--scalar", scalar, "--csv", "-", "--samples", "997"}));
      ASSERT_EQ(rows.size(), 997U);
      for (const CsvRow& row : rows) {
        EXPECT_EQ(row.table - row.exact, row.error);
        EXPECT_EQ(row.table_slope - row.exact_slope, row.slope_error);
        // Three digits of the bound are stated.
        EXPECT_LE(std::fabs(row.error), 1.005 * error) << row.argument;
      }
    }
  }
}

TEST_F(CurveCommand, CsvHoldsTheCurveAndItsDerivatives) {
  const std::vector<CsvRow> rows = parsed_csv(curve({"cubic", "--csv", "-"}));
  ASSERT_EQ(rows.size(), 101U);
  EXPECT_EQ(rows.front().argument, 0.0);
  EXPECT_EQ(rows.back().argument, 1.0);
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const double r = rows[i].argument;
    EXPECT_NEAR(r, 0.01 * static_cast<double>(i), 0x1p-28);
    EXPECT_NEAR(rows[i].exact, 1 - 3 * r * r + 2 * r * r * r, 1e-15);
    EXPECT_NEAR(rows[i].exact_slope, 6 * r * (r - 1), 1e-14);
    EXPECT_NEAR(rows[i].second, 12 * r - 6, 1e-13);
  }
  EXPECT_EQ(parsed_csv(curve({"cubic", "--csv", "-", "--samples", "2"})).size(), 2U);
}

TEST_F(CurveCommand, FilesHoldWhatStandardOutputWouldShow) {
  for (const char* kind : {"--csv", "--svg"}) {
    const std::string shown = curve({"bezier", kind, "-"});
    const std::string summary = curve({"bezier", kind, "made"});
    EXPECT_EQ(folder_.read("made"), shown) << kind;
    EXPECT_EQ(summary.rfind("made: bezier, b = (1, 1, 1, 0, 0, 0); table of ", 0), 0U) << summary;
    EXPECT_EQ(lines_of(summary).size(), 1U) << summary;
  }
  EXPECT_EQ(folder_.everything(), std::vector<std::string>{"made"});
}

TEST_F(CurveCommand, PicturesAreWellFormed) {
  for (const CatalogueEntry& entry : curve_catalogue()) {
    const std::string name(entry.name);
    SCOPED_TRACE(name);
    const std::string svg = curve({name, "--svg", "-"});
    EXPECT_EQ(draw::xml_fault(svg), "");
    const std::size_t points =
        static_cast<std::size_t>(entry.make(initial_values(entry)).control_points().count);
    for (const char* group :
         {"legend", "argument-axis", "values", "curves", "errors", "error-curve", "caption"}) {
      EXPECT_EQ(draw::occurrences(svg, std::string("class=\"") + group + '"'),
                group == std::string("legend") ? 2U : 1U)
          << group;
    }
    EXPECT_EQ(draw::occurrences(svg, "class=\"control-points\""), points > 0 ? 1U : 0U);
    EXPECT_EQ(draw::occurrences(svg, ">stated bound<"), 1U);
    EXPECT_NE(svg.find(entry.family == CurveFamily::step ? ">t<" : ">r<"), std::string::npos);
    EXPECT_LT(svg.size(), 120000U);
  }
}

// As the papers' captions: F' = 0.5 dF/dr, F'' = 0.2 d^2F/dr^2.
TEST_F(CurveCommand, PictureSaysHowDerivativesAreScaled) {
  const std::string bezier = curve({"bezier", "--svg", "-"});
  EXPECT_EQ(draw::occurrences(bezier, ">F′ = 0.5 dF/dr<"), 1U);
  EXPECT_EQ(draw::occurrences(bezier, ">F″ = 0.2 d²F/dr²<"), 1U);
  EXPECT_EQ(draw::occurrences(bezier, ">control points<"), 1U);
  const std::string hard = curve({"arctangent", "--set", "c1=1000", "--svg", "-"});
  EXPECT_EQ(draw::occurrences(hard, ">F′ = 0.002 dF/dr<"), 1U);
  EXPECT_EQ(draw::occurrences(hard, ">F″ = 5·10⁻⁶ d²F/dr²<"), 1U);
  EXPECT_EQ(draw::occurrences(curve({"polynomial", "--svg", "-"}), ">μ′ = dμ/dt<"), 1U);
}

TEST_F(CurveCommand, PictureOfAStepMayHaveARisingRange) {
  const std::string svg = curve({"polynomial", "--rising-range", "0.2", "--svg", "-"});
  EXPECT_EQ(draw::xml_fault(svg), "");
  EXPECT_NE(svg.find(", rising range 0.2<"), std::string::npos);
  // Five times as steep, in a legend that has factors 1, 1/2 and 1/5 of powers of ten.
  EXPECT_EQ(draw::occurrences(svg, ">μ′ = 0.2 dμ/dt<"), 1U);
  EXPECT_TRUE(curve({"polynomial", "--rising-range", "1", "--svg", "-"}) ==
              curve({"polynomial", "--svg", "-"}));
}

TEST_F(CurveCommand, PicturesThatComeWithNearfieldAreThoseOfTheCommand) {
  const std::string folder = NEARFIELD_SOURCE_DIR "/host_sim/pictures/";
  for (const char* name : {"bezier", "arctangent"}) {
    const std::string file = folder + "curve_" + name + ".svg";
    EXPECT_TRUE(curve({name, "--svg", "-"}) == contents_of(file))
        << "make it anew: nearfield curve " << name << " --svg " << file;
  }
}

TEST_F(CurveCommand, TableIsAsAskedFor) {
  const auto expect_part = [this](const std::vector<std::string>& arguments, const std::string& part) {
    const std::string text = curve(arguments);
    EXPECT_NE(text.find(part), std::string::npos) << typed(arguments) << "\n" << text;
  };
  expect_part({"bezier", "--degree", "2"}, "degree 2, ");
  expect_part({"bezier", "--segments", "64"}, ", 64 segments\n");
  expect_part({"bezier", "--degree", "1", "--segments", "7"}, "degree 1, 7 segments\n");
  expect_part({"bezier", "--bits", "16", "--error", "12"}, "coefficients of 16 bits\n");
  expect_part({"bezier", "--argument", "square"}, "argument       r^2");
  expect_part({"wyvill", "--argument", "r"}, "argument       r, ");
  expect_part({"bezier", "--scalar", "q16"}, "Fixed<16>, ");
  expect_part({"bezier", "--scalar", "float"}, "table          float, ");
  EXPECT_LE(stated_error(curve({"blanc", "--bytes", "16384", "--error", "24"})), 0x1p-24);
  EXPECT_LT(stated_error(curve({"bezier", "--error", "0"})), stated_error(curve({"bezier"})));
}

TEST_F(CurveCommand, SaysWhenNoTableIsAsGoodAsUsual) {
  const std::string missed = "no table of at most 1024 bytes comes within 2^-20; the best reaches ";
  for (const char* kind : {"", "--svg", "--csv"}) {
    std::vector<std::string> arguments = {"arctangent", "--set", "c1=100"};
    if (*kind != 0) arguments.insert(arguments.end(), {kind, "made"});
    EXPECT_NE(curve(arguments).find("\n" + missed + "0.00"), std::string::npos) << typed(arguments);
  }
  EXPECT_NE(folder_.read("made").find("argument,"), std::string::npos);
  EXPECT_EQ(curve({"bezier"}).find("no table"), std::string::npos);
}

TEST_F(CurveCommand, WithoutAnyTableTheCurveIsStillShown) {
  const std::vector<std::string> arguments = {"logistic", "--set", "alpha=200", "--bytes", "4"};
  const auto with = [&arguments](const std::vector<std::string>& more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_NE(curve(arguments).find("no table of at most 4 bytes can hold this curve\n"), std::string::npos);
  const std::vector<std::string> rows = lines_of(curve(with({"--csv", "-", "--samples", "3"})));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2], "0,0.5,,,50,,,0");
  const std::string svg = curve(with({"--svg", "-"}));
  EXPECT_EQ(draw::xml_fault(svg), "");
  EXPECT_EQ(draw::occurrences(svg, "class=\"errors\""), 0U);
}

TEST_F(CurveCommand, RangeControlMovesTheEnd) {
  const std::string text = curve({"cubic", "--set", "w1=0.5", "--set", "w2=0.25"});
  EXPECT_EQ(text.rfind("cubic, w1 = 0.5, w2 = 0.25\n", 0), 0U) << text;
  EXPECT_NE(text.find("r from 0 to 0.75; "), std::string::npos) << text;
  EXPECT_EQ(
      curve({"bezier", "--set", "w1=0.5"}).rfind("bezier, b = (1, 1, 1, 0, 0, 0), w1 = 0.5, w2 = 0.5\n", 0),
      0U);
  // Without a change of range the values stay.
  EXPECT_EQ(parsed_csv(curve({"cubic", "--set", "w1=1", "--csv", "-"}))[50].exact, 0.5);
}

}  // namespace
}  // namespace nearfield::host
