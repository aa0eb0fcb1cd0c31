// A simulation's results for people: trace, timeline, pictures, summary.
#pragma once

#include <string>
#include <vector>

#include "simulate/simulation.hpp"

namespace nearfield::host {

// A tick worth a picture, with the letter that marks it on the timeline and whose nearest pair the picture shows.
enum class Nearness { person, cell };
struct TellingMoment {
  std::size_t tick = 0;
  std::string letter;
  std::string title;
  Nearness shown = Nearness::person;
};

// At most six, in order of time: the start, where the arm first slows and stops for the person, the least clearance
// to the person and to the cell, and where the arm runs freely again.
std::vector<TellingMoment> telling_moments(const CompiledWorkCell& cell, const SimulationResult& result);

// One line per tick, a header line first; metres, seconds, radians. Formatted without locale, the same everywhere.
std::string trace_csv(const CompiledWorkCell& cell, const SimulationResult& result);

std::string timeline_of(const CompiledWorkCell& cell, const SimulationResult& result,
                        const std::vector<TellingMoment>& moments);

std::string picture_of(const CompiledWorkCell& cell, const SimulationResult& result, const TellingMoment& moment);

// A few lines in words and numbers, without the digest.
std::string summary_of(const CompiledWorkCell& cell, const SimulationResult& result);

}  // namespace nearfield::host
