#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/command_registry.hpp"
#include "app/commands/batch.hpp"
#include "app/commands/export.hpp"
#include "app/commands/georeference.hpp"
#include "app/commands/project_commands.hpp"
#include "app/commands/simulate.hpp"

namespace stemwise {
namespace {

void add_export(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "export", "Layers of a project for other programs; the suffix says the format");
  const auto options = std::make_shared<ExportCommandOptions>();
  command.add_option("PROJECT", options->project, "Project file")->required();
  command.add_option("-o,--output", options->output, "File to write: gpkg, geojson, csv, tsv, shp, fgb, kml, kmz, gpx, dxf, xlsx, ods")->required();
  command.add_option("--layer", options->layer,
                     "trees (default), observations, matches, links, inventories, coverage, or forestgeo (census tables); GPKG, XLSX and ODS take all but forestgeo when none is named");
  command.add_option("--crs", options->crs, "EPSG:N (default: that of the georeference, else local coordinates)");
  command.add_flag("--decimal-comma", options->decimal_comma, "1,5 instead of 1.5 in CSV");
  command.add_option("--delimiter", options->delimiter, "Between the fields of CSV (default: comma)");
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_export(*options, session); }; });
}

void add_report(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "report", "Growth report of a project: .pdf, .html, .xlsx or .csv");
  const auto options = std::make_shared<ReportCommandOptions>();
  command.add_option("PROJECT", options->project, "Project file")->required();
  command.add_option("-o,--output", options->output, "The report to write; the suffix says the format")->required();
  command.add_option("--area-ha", options->area_ha, "Area behind the per-hectare figures (default: each survey's coverage)");
  command.add_option("--class-width-cm", options->class_width_cm, "Width of the DBH classes (default 5)")->check(CLI::Range(0.5, 100.0));
  command.add_option("--rules", options->rules, "Flag implausible growth: ctfs, forestgeo, scbi, treedata, lidar, none, or a JSON file of own rules; kept in the project");
  command.add_flag("--field-check", options->field_check, "The sheet to take outside in place of the report: doubtful trees from the three nearest sure ones; also .gpx");
  command.add_option("--field-check-trees", options->field_check_trees, "How many trees at most (default 100)")->check(CLI::Range(1, 100000));
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_report(*options, session); }; });
}

void add_georeference_details(CLI::App& command, GeoreferenceOptions& options) {
  command.add_flag("--translation-only", options.translation_only, "With --control: keep the azimuth that --azimuth gives (one point is enough)");
  command.add_option("--azimuth", options.azimuth_deg, "Degrees clockwise from north to the reference's +y axis");
  command.add_option("--azimuth-kind", options.azimuth_kind, "North that the azimuth counts from: true (default), grid (of the UTM zone) or magnetic");
  command.add_option("--declination", options.declination_deg, "Magnetic declination in degrees, east positive (default: a magnetic model, on the reference's day)");
  command.add_option("--magnetic-model", options.magnetic_model, "GeographicLib's magnetic model (default wmm2020), where its data is installed");
  command.add_option("--geoid", options.geoid, "Heights are above this geoid, not the ellipsoid: a model of GeographicLib (egm2008-5) or a grid of PROJ (egm96_15.gtx)");
  command.add_flag("--level", options.level, "With --control: the reference's z is the vertical (default: decided by the points' heights)");
  command.add_flag("--tilted", options.tilted, "With --control: the reference leans; three points with heights tell how");
  command.add_option("--inventory", options.inventory, "Inventory whose coordinates --crs names, or whose trajectory --gnss follows (default: the reference)");
  command.add_option("--trajectory", options.trajectory, "With --gnss: the trajectory file (default: that of the inventory's frame folder)");
  command.add_option("--time-offset-s", options.time_offset_s, "With --gnss: added to the track's time stamps");
  command.add_option("--sd-m", options.sd_m, "With --anchor and --crs: how well the position is known, one axis")->check(CLI::NonNegativeNumber);
  command.add_option("--outlier-m", options.outlier_m, "With --control: points farther than this from the others' agreement are left out (default 3)")->check(CLI::PositiveNumber);
}

void add_georeference(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "georeference", "Place a project on the earth");
  const auto options = std::make_shared<GeoreferenceOptions>();
  command.add_option("PROJECT", options->project, "Project file")->required();
  CLI::Option_group& by = *command.add_option_group("Placed by", "Exactly one of these");
  by.add_option("--control", options->control, "CSV of control points: x_m, y_m, z_m (or tree_id), lon, lat, height_m");
  by.add_option("--anchor", options->anchor, "LAT,LON,H,AZIMUTH of the reference's origin and of its +y axis");
  by.add_option("--gnss", options->gnss, "CSV of a GNSS track: timestamp, lat, lon, height_m, sd_m, joined to the trajectory by time");
  by.add_option("--crs", options->crs, "EPSG:N, when the coordinates are already those of a map");
  by.require_option(1);
  add_georeference_details(command, *options);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_georeference(*options, session); }; });
}

void add_merge(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "merge", "Choose how the sightings of a tree become one");
  const auto options = std::make_shared<MergeOptions>();
  command.add_option("PROJECT", options->project, "Project file")->required();
  command.add_option("--policy", options->policy, "min-dbh (default), newest, best or mean");
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_merge(*options, session); }; });
}

void add_remove(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "remove", "Take surveys out of a project; what the others have stays as it is");
  const auto options = std::make_shared<RemoveOptions>();
  command.add_option("PROJECT", options->project, "Project file")->required();
  command.add_option("INVENTORY", options->inventories, "Names of the surveys")->required();
  command.add_option("-o,--output", options->output, "Another project to write (default: PROJECT)");
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_remove(*options, session); }; });
}

void add_snapshot(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "snapshot", "A picture of a project; needs no display");
  const auto options = std::make_shared<SnapshotOptions>();
  const auto size = std::make_shared<std::string>("1600x1000");
  command.add_option("PROJECT", options->project, "Project file")->required();
  command.add_option("-o,--output", options->output, "The PNG to write")->required();
  command.add_option("--view", options->view, "map (default) or 3d");
  command.add_option("--color-by", options->color_by, "inventory, fate (default), dbh, growth, residual, confidence or times_seen");
  command.add_option("--size", *size, "WIDTHxHEIGHT in pixels (default 1600x1000)");
  command.add_flag("--dark", options->dark, "Dark theme");
  command.callback([options, size, &chosen] {
    char end = 0;
    if (std::sscanf(size->c_str(), "%dx%d%c", &options->width_px, &options->height_px, &end) != 2) {
      throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, for example 1600x1000");
    }
    chosen.run = [options](Session& session) { return run_snapshot(*options, session); };
  });
}

void add_simulate_options(CLI::App& command, SimulateOptions& options) {
  SimulateSettings& s = options.settings;
  command.add_option("-o,--output", options.folder, "Folder to fill")->required();
  command.add_option("--years", options.years, "Years of the surveys (default 2015,2019,2023)")->delimiter(',')->check(CLI::Range(1000, 9999));
  command.add_option("--stems", s.stems, "Living stems at the first survey (default 600)");
  command.add_option("--area-ha", s.area_ha, "Area (default: 450 stems to the hectare)");
  command.add_option("--resurvey", options.resurvey, "Make the next survey of this real inventory instead");
  command.add_option("--position-noise-m", s.position_noise_m, "Standard deviation of a position, one axis (default 0.1)");
  command.add_option("--dbh-noise-cm", s.dbh_noise_cm, "Standard deviation of a DBH (default 1)");
  command.add_option("--drop", s.drop, "Share of stems that a survey misses (default 0.1)");
  command.add_option("--false", s.false_stems, "Share of stems added that are none (default 0.02)");
  command.add_option("--yaw-deg", s.yaw_deg, "Turn of every survey's frame (default: any)");
  command.add_option("--shift-m", s.shift_m, "How far away a survey's origin may lie (default 300)");
  command.add_option("--drift", s.drift, "How far the trajectory of frames has drifted at its end, as a share of its length (default 0)");
  command.add_option("--tilt-deg", s.tilt_deg, "How far a survey's vertical is off (default 0)");
  command.add_flag("--grid", s.planted, "A planted stand in rows");
  command.add_flag("--frames", s.frames, "Surveys as frame folders");
}

void add_simulate(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "simulate", "A synthetic forest over several years, with its truth");
  const auto options = std::make_shared<SimulateOptions>();
  add_simulate_options(command, *options);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_simulate(*options, session); }; });
}

void add_batch(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "batch", "Align many plots; a failed one stops nothing, a rerun does only what changed");
  const auto options = std::make_shared<BatchOptions>();
  const auto shard = std::make_shared<std::string>();
  command.add_option("MANIFEST", options->manifest, "CSV with plot,path and optionally name,date,reference")->required();
  command.add_option("-o,--output", options->folder, "Folder for the results")->required();
  command.add_option("--shard", *shard, "K/N: every N-th plot, beginning with the K-th");
  command.callback([options, shard, &chosen] {
    char end = 0;
    if (!shard->empty() && std::sscanf(shard->c_str(), "%d/%d%c", &options->shard, &options->shards, &end) != 2) {
      throw CLI::ValidationError("--shard", "expected K/N, for example 1/4");
    }
    chosen.run = [options](Session& session) { return run_batch(*options, session); };
  });
}

}  // namespace

void add_project_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  add_georeference(root, common, chosen);
  add_merge(root, common, chosen);
  add_remove(root, common, chosen);
  add_export(root, common, chosen);
  add_report(root, common, chosen);
  add_snapshot(root, common, chosen);
  add_simulate(root, common, chosen);
  add_batch(root, common, chosen);
}

}  // namespace stemwise
