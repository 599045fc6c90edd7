#pragma once
#include <string>
#include <vector>

#include "app/window/import_memory.hpp"
#include "core/jobs/progress.hpp"
#include "io/preview_inventory.hpp"
#include "ui/import_view.hpp"

namespace stemwise {

/// A file that was read and waits to be taken into the project, in the import dialog or on its way past it.
struct PendingImport {
  ui::ImportSettings settings;
  InventoryPreview preview;    ///< read with these settings
  bool remembered = false;     ///< the settings are those of the last file with this header
  int generation = 0;          ///< goes up with every change: an older reading that arrives late is dropped
  bool reading = false;
  bool edited = false;         ///< by a person, in the dialog
};

/// Reads a file as it is, or as the last one with its header was read. Ready to be aligned (frames are made one inventory).
/// Throws Cancelled.
PendingImport read_pending(const std::string& path, const ImportMemory& memory, const Progress& progress);
/// The same file once more, with other settings.
InventoryPreview read_again(const std::string& path, const ui::ImportSettings& settings, const Progress& progress);

ReadOptions read_options(const ui::ImportSettings& settings);
/// Something was guessed or went wrong: a person should look at it.
bool is_in_doubt(const PendingImport& pending);
ui::ImportFile import_view(const PendingImport& pending);

}  // namespace stemwise
