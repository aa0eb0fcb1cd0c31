#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "command/command.hpp"
#include "command/drawing.hpp"
#include "command/field_options.hpp"
#include "command/progress.hpp"
#include "gallery/field_facts.hpp"
#include "gallery/gallery_page.hpp"
#include "model/scene_reader.hpp"
#include "text/input_error.hpp"
#include "text/names.hpp"
#include "text/read_file.hpp"

#ifndef NEARFIELD_SCENE_FOLDER
#error "the build names the folder of the scenes that come with Nearfield"
#endif

namespace nearfield::host {
namespace {

std::vector<OptionDescription> gallery_options() {
  return {{"output", "FILE.html", "where to write the page (required)"},
          {"chapter", "NAME", "only this chapter: the name of its index without .json", true},
          threads_option(),
          {"help", "", "this text"}};
}

void print_help() {
  std::printf(
      "usage: nearfield gallery [FOLDER] --output FILE.html [OPTION...]\n\n"
      "One page of HTML with every figure of the indexes FOLDER/*.json (host_sim/FORMATS.md), all pictures "
      "inside it,\n"
      "drawn as the verbs `slice`, `render` and `curve` draw them. Without FOLDER: the gallery that comes "
      "with\n"
      "Nearfield.\n\n%s",
      describe(gallery_options()).c_str());
}

// One picture of the page, its command understood.
struct Job {
  const GalleryChapter* chapter;
  std::string figure;         // how errors call it
  std::size_t number_in_row;  // from 1
  const GalleryPicture* picture;
  const DrawingVerb* verb;
  Options options;

  [[noreturn]] static void refuse(const GalleryChapter& chapter, const std::string& figure,
                                  std::size_t number_in_row, const GalleryPicture& picture,
                                  const std::string& message, const std::string& allowed) {
    throw InputError(chapter.file, picture.position, picture.path + ".command",
                     figure + ", picture " + std::to_string(number_in_row) + ": " + message, allowed);
  }
  [[noreturn]] void refuse(const std::string& message) const {
    refuse(*chapter, figure, number_in_row, *picture, message,
           "`nearfield " + verb->name + " --help` tells more");
  }
};

const DrawingVerb* find_verb(const std::string& name) {
  for (const DrawingVerb& verb : drawing_verbs()) {
    if (verb.name == name) return &verb;
  }
  return nullptr;
}

bool has_option(const DrawingVerb& verb, const std::string& name) {
  for (const OptionDescription& option : verb.options()) {
    if (option.name == name) return true;
  }
  return false;
}

// The command as the verb itself reads it. UsageError as there.
Options options_of(const DrawingVerb& verb, const GalleryPicture& picture, const std::string& folder) {
  std::vector<std::string> words(picture.command.begin() + 1, picture.command.end());
  const Options given(verb.options(), words, Operand::one);
  for (const std::string& own : {verb.output, std::string("threads"), std::string("help")}) {
    if (given.has(own)) throw UsageError("--" + own + " is not for pictures of a gallery");
  }
  // Layers have so many shades that they would be megabytes of lines.
  const std::string ending = given.has("bands") ? ".png" : verb.ending;
  words.push_back("--" + verb.output + "=picture" + ending);
  if (has_option(verb, "threads")) words.push_back("--threads=1");  // pictures are drawn side by side
  Options options(verb.options(), words, Operand::one);
  if (verb.of_scene) options.look_for_operand_in(folder);
  return options;
}

Job job_of(const GalleryChapter& chapter, const GalleryFigure& figure, std::size_t number_in_row,
           const std::string& folder) {
  const GalleryPicture& picture = figure.pictures[number_in_row - 1];
  const std::string name =
      "figure " + (figure.figure ? *figure.figure + ", " : std::string()) + in_quotes(figure.title);
  const DrawingVerb* verb = find_verb(picture.command.front());
  std::vector<std::string_view> names;
  for (const DrawingVerb& each : drawing_verbs()) names.push_back(each.name);
  if (verb == nullptr) {
    Job::refuse(chapter, name, number_in_row, picture, unknown_name("verb", picture.command.front(), names),
                "one of " + joined(names));
  }
  try {
    return {&chapter, name, number_in_row, &picture, verb, options_of(*verb, picture, folder)};
  } catch (const UsageError& error) {
    Job::refuse(chapter, name, number_in_row, picture, error.what(),
                "`nearfield " + verb->name + " --help` tells more");
  }
}

// Budgets are of Fixed<27>; a picture in another number type may be of a field that does not fit that.
std::string budget_of(const Options& options, const SceneDescription& scene) {
  if (scalar_of(options) == FieldScalar::q27) return budget_in_words(scene);
  try {
    return budget_in_words(scene) + " (in Fixed<27>)";
  } catch (const InputError&) {
    return "not stated: the field does not fit Fixed<27>";
  }
}

DrawnPicture drawn(const Job& job) {
  DrawnPicture picture;
  try {
    Drawing drawing = job.verb->draw(job.options, {});
    picture.bytes = std::move(drawing.bytes);
    picture.said = std::move(drawing.said);
    picture.warning = std::move(drawing.warning);
    if (!job.verb->of_scene) return picture;
    const SceneDescription scene = scene_of(job.options, "nearfield " + job.verb->name + " SCENE");
    picture.scene_file = std::filesystem::path(scene.file).filename().string();
    picture.scene_text = read_file(scene.file);
    picture.certificate = certificate_in_words(*field_of(job.options, scene));
    picture.budget = budget_of(job.options, scene);
  } catch (const UsageError& error) {
    job.refuse(error.what());
  } catch (const InputError& error) {
    if (job.verb->of_scene) throw;  // it names the scene's place
    job.refuse(error.what());
  }
  return picture;
}

// All pictures, by several threads at once. What is thrown is what the first picture that fails throws.
std::vector<DrawnPicture> draw_all(const std::vector<Job>& jobs, unsigned threads) {
  std::vector<DrawnPicture> pictures(jobs.size());
  std::vector<std::exception_ptr> failures(jobs.size());
  std::atomic<std::size_t> first_failure{jobs.size()};
  Progress progress("drawing");
  for_each_row(
      jobs.size(), threads,
      [&](std::size_t i) {
        if (i > first_failure) return;
        try {
          pictures[i] = drawn(jobs[i]);
        } catch (...) {
          failures[i] = std::current_exception();
          std::size_t known = first_failure;
          while (i < known && !first_failure.compare_exchange_weak(known, i)) {
          }
        }
      },
      [&progress](double done) { progress.report(done); });
  if (first_failure < jobs.size()) std::rethrow_exception(failures[first_failure]);
  return pictures;
}

std::vector<GalleryChapter> chapters_of(const Options& options, const std::string& folder) {
  std::vector<GalleryChapter> all = read_gallery(folder);
  if (!options.has("chapter")) return all;
  std::vector<std::string_view> names;
  for (const GalleryChapter& chapter : all) names.push_back(chapter.name);
  const std::vector<std::string> wanted = options.values("chapter");
  std::vector<GalleryChapter> chosen;
  for (const std::string& name : wanted) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UsageError("--chapter: " + unknown_name("name", name, names) + ": it is one of " + joined(names));
  }
  for (const GalleryChapter& chapter : all) {
    if (std::find(wanted.begin(), wanted.end(), chapter.name) != wanted.end()) chosen.push_back(chapter);
  }
  return chosen;
}

}  // namespace

int run_gallery(const std::vector<std::string>& arguments) {
  const Options options(gallery_options(), arguments, Operand::one);
  if (options.has("help")) {
    print_help();
    return 0;
  }
  const std::string output = output_of(options, {".html"});
  const unsigned threads = threads_of(options);
  const std::string folder = options.operand().value_or(NEARFIELD_SCENE_FOLDER "/gallery");
  const std::vector<GalleryChapter> chapters = chapters_of(options, folder);
  std::vector<Job> jobs;
  std::size_t figures = 0;
  for (const GalleryChapter& chapter : chapters) {
    for (const GalleryFigure& figure : chapter.figures) {
      ++figures;
      for (std::size_t i = 1; i <= figure.pictures.size(); ++i)
        jobs.push_back(job_of(chapter, figure, i, folder));
    }
  }
  const std::vector<DrawnPicture> pictures = draw_all(jobs, threads);
  const std::string page = gallery_page(chapters, pictures);
  write_file(output, page);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!pictures[i].warning.empty()) {
      std::fprintf(stderr, "%s: %s: %s, picture %zu: warning: %s\n", jobs[i].chapter->file.c_str(),
                   (jobs[i].picture->path + ".command").c_str(), jobs[i].figure.c_str(),
                   jobs[i].number_in_row, pictures[i].warning.c_str());
    }
  }
  std::printf("%s: %zu figures, %zu pictures, %.1f MB\n", output.c_str(), figures, jobs.size(),
              static_cast<double>(page.size()) / 1e6);
  return 0;
}

}  // namespace nearfield::host
