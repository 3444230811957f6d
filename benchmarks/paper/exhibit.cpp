#include "paper/exhibit.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "output/files/csv_writer.hpp"
#include "output/files/file_io.hpp"

namespace moat::paper {

using Json = nlohmann::ordered_json;

struct Exhibit::Content {
  Json json;
  std::size_t reported = 0;
  bool all_held = true;
};

Exhibit::Exhibit(std::filesystem::path folder, std::string id, std::string title, bool coarse)
    : folder_{std::move(folder)}, id_{std::move(id)}, coarse_{coarse}, content_{std::make_unique<Content>()} {
  content_->json = {{"id", id_},
                    {"title", std::move(title)},
                    {"skipped", ""},
                    {"blocks", Json::array()},
                    {"checks", Json::array()},
                    {"findings", Json::array()}};
}
Exhibit::~Exhibit() = default;

void Exhibit::text(const std::string& paragraph) {
  content_->json["blocks"].push_back({{"type", "text"}, {"text", paragraph}});
}

void Exhibit::table(const ShownTable& table) {
  content_->json["blocks"].push_back(
      {{"type", "table"}, {"caption", table.caption}, {"header", table.header}, {"rows", table.rows}});
}

void Exhibit::figure(const ShownFigure& figure) {
  constexpr int width = 1000;
  const std::string file = figure.name + ".svg";
  write_svg(figure.charts, folder_ / file, width, figure.panel_height, figure.columns);
  content_->json["blocks"].push_back(
      {{"type", "figure"}, {"name", figure.name}, {"file", file}, {"caption", figure.caption}});
}

void Exhibit::numbers(const std::string& name, const Table& table) {
  const std::string file = name + ".csv";
  write_csv(table, folder_ / file);
  content_->json["blocks"].push_back({{"type", "numbers"}, {"file", file}});
}

void Exhibit::assert_that(bool held, const std::string& what) {
  content_->json["checks"].push_back({{"what", what}, {"held", held}});
  content_->all_held = content_->all_held && held;
  if (!held) std::fprintf(stderr, "moat: %s: did not hold: %s\n", id_.c_str(), what.c_str());
}

void Exhibit::report(std::size_t count) { content_->reported += count; }

void Exhibit::finding(const Finding& finding) {
  const char* verdict = finding.verdict == Verdict::holds    ? "holds"
                        : finding.verdict == Verdict::partly ? "partly"
                                                             : "does not hold";
  content_->json["findings"].push_back({{"source", finding.source},
                                        {"claim", finding.claim},
                                        {"criterion", finding.criterion},
                                        {"found", finding.found},
                                        {"verdict", verdict}});
}

void Exhibit::skip(const std::string& reason) {
  content_->json["skipped"] = reason;
  std::fprintf(stderr, "moat: %s is skipped: %s\n", id_.c_str(), reason.c_str());
}

bool Exhibit::write() const {
  Json json = content_->json;
  json["reported"] = content_->reported;
  write_file(folder_ / (id_ + ".json"), json.dump(1) + "\n");
  return content_->all_held;
}

int run_exhibit(int argc, char** argv, const std::string& id, const std::string& title,
                const std::function<void(Exhibit&)>& show) {
  constexpr int exit_usage = 2;
  CLI::App app{title};
  std::string folder = "results/paper";
  bool coarse = false;
  app.add_option("--out", folder, "folder for figures, tables and " + id + ".json")->capture_default_str();
  app.add_flag("--coarse", coarse, "few points per curve, to try the page");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  try {
    std::filesystem::create_directories(folder);
    Exhibit exhibit{folder, id, title, coarse};
    show(exhibit);
    return exhibit.write() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string ratio(double computed, double printed) { return fixed(computed / printed, 3); }

}  // namespace moat::paper
