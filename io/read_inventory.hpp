#pragma once
#include <map>
#include <optional>
#include <string>

#include "core/base/date.hpp"
#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"

namespace stemwise {

/// What a person overrides when an inventory is read (cli.md, "Overrides for reading"). Everything empty: recognised.
struct ReadOptions {
  /// Our name of a column -> the file's header: x, y, z, lon, lat, azimuth, distance, dbh, circumference, height, id, species,
  /// status, date, plot, axis_x, axis_y, axis_z. `--map x=Easting`. An empty header: no column is read as that.
  std::map<std::string, std::string> columns;
  /// Our name of a column -> m, dm, cm, mm, ft, in, deg, gon, rad. `--unit dbh=mm`; x stands for y too.
  std::map<std::string, std::string> units;
  std::string sheet;        ///< sheet of a workbook, layer of a GIS file, inventory of a project
  std::string plot_column;  ///< header of the column that tells the plots of one file apart
  std::string plot;         ///< its value: only these rows are read
  std::optional<Date> date; ///< replaces every date of the file
  std::optional<int> epsg;  ///< system of the table's x and y, for a file that does not say it
  std::map<std::string, StemStatus> status_codes;  ///< what a code in the status column means, where it is not the usual
  int threads = 0;          ///< for frame folders; 0: all of the machine
};

/// Reads any inventory there is a reader for (data-formats.md), recognised by its content: a frame folder (`frames` set,
/// `stems` empty: making the global inventory is core's), a table of stems, a workbook, GIS points, or one inventory of a
/// Stemwise project. The name is the file's stem or the folder's name; `id` is none. What was recognised or guessed is in
/// `source.notes`; guesses are warnings too; every bad row is a warning that names file, row and column. A failure, with
/// what helps, when no row is usable.
Result<Inventory> read_inventory(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
