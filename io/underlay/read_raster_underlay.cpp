#include "io/underlay/read_raster_underlay.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/gdal_dataset.hpp"
#include "io/gdal_session.hpp"
#include "io/underlay/file_placement.hpp"
#include "io/underlay/shade_heights.hpp"

namespace stemwise {
namespace {

constexpr int nodes_per_side = 17;

/// Pixel and line to the file's coordinates: x = a[0] + a[1] px + a[2] line, y = a[3] + a[4] px + a[5] line.
struct GeoTransform {
  double a[6] = {};
  Eigen::Vector3d file_of(const Eigen::Vector2d& px) const {
    return {a[0] + a[1] * px.x() + a[2] * px.y(), a[3] + a[4] * px.x() + a[5] * px.y(), 0.0};
  }
};

/// The part of the raster that is read, and the size it is read at.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
  int width_px = 0, height_px = 0;
};

struct Step {
  const Progress* progress;
  bool is_cancelled = false;
};

int CPL_STDCALL tell(double fraction, const char*, void* data) {
  auto& step = *static_cast<Step*>(data);
  try {
    step.progress->at(fraction, "Reading pixels");
  } catch (const Cancelled&) {
    step.is_cancelled = true;
  }
  return step.is_cancelled ? FALSE : TRUE;
}

Issue error_in(const std::string& path, std::string text, std::string help) { return {Severity::error, path, 0, {}, std::move(text), std::move(help)}; }

std::string wkt_of(GDALDataset& dataset) {
  const OGRSpatialReference* system = dataset.GetSpatialRef();
  if (!system || system->IsLocal()) return "";
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  system->exportToWkt(&text, options);
  const std::string wkt = text ? text : "";
  CPLFree(text);
  return wkt;
}

/// One raster on its way to become an underlay.
class RasterReading {
 public:
  RasterReading(GDALDataset& dataset, const UnderlayRequest& request, const FilePlacement& placement, const Progress& progress)
      : dataset_(dataset), request_(request), placement_(placement), progress_(progress) {}

  Result<RasterUnderlay> read() {
    if (dataset_.GetGeoTransform(transform_.a) != CE_None)
      return fail("the picture does not say where it lies", "put a world file beside it (" + world_file_name() + "), or save it from a GIS as GeoTIFF");
    if (!choose_window()) return Result<RasterUnderlay>::failure(elsewhere(request_, placement_, file_box()));
    RasterUnderlay raster{.width_px = window_.width_px, .height_px = window_.height_px, .system = placement_.system()};
    if (!lay_net(raster)) return fail("it cannot be brought into the project's frame", "save it in the project's coordinate system");
    if (!read_pixels(raster)) return fail("its pixels cannot be read", "the file may be damaged or cut off: copy it again");
    bool any = false;
    for (std::size_t i = 3; i < raster.rgba.size() && !any; i += 4) any = raster.rgba[i] != 0;
    if (!any) return fail("it holds no data around the stems", "choose a file that covers the plot");
    return raster;
  }

 private:
  Result<RasterUnderlay> fail(std::string text, std::string help) const {
    return Result<RasterUnderlay>::failure(error_in(request_.path, std::move(text), std::move(help)));
  }

  std::string world_file_name() const {
    const std::filesystem::path path(request_.path);
    const std::string suffix = path.extension().string();
    return path.stem().string() + (suffix.size() >= 4 ? std::string(".") + suffix[1] + suffix.back() + "w" : ".wld");
  }

  Eigen::AlignedBox2d file_box() const {
    Eigen::AlignedBox2d box;
    for (const double x : {0, dataset_.GetRasterXSize()})
      for (const double y : {0, dataset_.GetRasterYSize()}) box.extend(transform_.file_of({x, y}).head<2>());
    return box;
  }

  /// False where no pixel lies in the wanted area.
  bool choose_window() {
    double inverse[6];
    const Eigen::AlignedBox2d area = placement_.area_in_file();
    if (area.isEmpty() || !GDALInvGeoTransform(transform_.a, inverse)) return false;
    GeoTransform pixel_of{};
    std::copy(inverse, inverse + 6, pixel_of.a);
    Eigen::AlignedBox2d px;
    for (const double x : {area.min().x(), area.max().x()})
      for (const double y : {area.min().y(), area.max().y()}) px.extend(pixel_of.file_of({x, y}).head<2>());
    const Eigen::AlignedBox2d all(Eigen::Vector2d::Zero(), Eigen::Vector2d(dataset_.GetRasterXSize(), dataset_.GetRasterYSize()));
    px = px.intersection(all);
    if (px.isEmpty() || px.sizes().minCoeff() <= 0.0) return false;
    window_.x = static_cast<int>(std::floor(px.min().x()));
    window_.y = static_cast<int>(std::floor(px.min().y()));
    window_.width = static_cast<int>(std::ceil(px.max().x())) - window_.x;
    window_.height = static_cast<int>(std::ceil(px.max().y())) - window_.y;
    const double smaller = std::min(1.0, static_cast<double>(most_raster_px) / std::max(window_.width, window_.height));
    window_.width_px = std::max(1, static_cast<int>(std::lround(window_.width * smaller)));
    window_.height_px = std::max(1, static_cast<int>(std::lround(window_.height * smaller)));
    return true;
  }

  std::optional<Eigen::Vector2d> place_of(double share_x, double share_y) const {
    const auto p = placement_.reference_from_file(transform_.file_of({window_.x + share_x * window_.width, window_.y + share_y * window_.height}));
    return p ? std::optional<Eigen::Vector2d>(p->head<2>()) : std::nullopt;
  }

  bool lay_net(RasterUnderlay& raster) const {
    raster.columns = raster.rows = placement_.system().empty() ? 2 : nodes_per_side;
    for (int row = 0; row < raster.rows; ++row)
      for (int column = 0; column < raster.columns; ++column) {
        const auto place = place_of(static_cast<double>(column) / (raster.columns - 1), static_cast<double>(row) / (raster.rows - 1));
        if (!place) return false;
        raster.nodes_in_reference_m.push_back(*place);
      }
    raster.pixel_m = (raster.node_m(raster.columns - 1, 0) - raster.node_m(0, 0)).norm() / raster.width_px;
    return raster.pixel_m > 0.0;
  }

  template <class Value>
  bool read_band(GDALRasterBand& band, std::vector<Value>& values, GDALDataType type, GDALRIOResampleAlg resampling, const Progress& progress) const {
    values.resize(static_cast<std::size_t>(window_.width_px) * window_.height_px);
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    Step step{&progress};
    extra.eResampleAlg = resampling;
    extra.pfnProgress = tell;
    extra.pProgressData = &step;
    const CPLErr error = band.RasterIO(GF_Read, window_.x, window_.y, window_.width, window_.height, values.data(), window_.width_px, window_.height_px, type, 0, 0, &extra);
    if (step.is_cancelled) throw Cancelled{};
    return error == CE_None;
  }

  /// The bands that are shown: red, green, blue, or one.
  std::vector<GDALRasterBand*> shown_bands() const {
    std::vector<GDALRasterBand*> bands;
    for (int i = 1; i <= dataset_.GetRasterCount(); ++i) {
      GDALRasterBand* band = dataset_.GetRasterBand(i);
      if (band->GetColorInterpretation() != GCI_AlphaBand) bands.push_back(band);
    }
    bands.resize(bands.size() >= 3 ? 3 : std::min<std::size_t>(1, bands.size()));
    return bands;
  }

  bool read_pixels(RasterUnderlay& raster) const {
    const std::vector<GDALRasterBand*> bands = shown_bands();
    if (bands.empty()) return false;
    const std::size_t pixels = static_cast<std::size_t>(raster.width_px) * raster.height_px;
    raster.rgba.assign(4 * pixels, 0);
    const bool has_palette = bands.size() == 1 && bands.front()->GetColorTable() != nullptr;
    const GDALRIOResampleAlg resampling = has_palette ? GRIORA_NearestNeighbour : GRIORA_Average;
    std::vector<std::uint8_t> mask;
    if (!read_band(*bands.front()->GetMaskBand(), mask, GDT_Byte, resampling, progress_.stage(0.8, 1.0))) return false;
    for (std::size_t i = 0; i < pixels; ++i) raster.rgba[4 * i + 3] = mask[i];
    if (has_palette) return paint_palette(*bands.front(), raster);
    std::vector<float> values;
    for (std::size_t channel = 0; channel < bands.size(); ++channel) {
      const double share = 0.8 / static_cast<double>(bands.size());
      if (!read_band(*bands[channel], values, GDT_Float32, resampling, progress_.stage(share * static_cast<double>(channel), share * static_cast<double>(channel + 1)))) return false;
      for (std::size_t i = 0; i < pixels; ++i)
        if (mask[i] == 0) values[i] = std::numeric_limits<float>::quiet_NaN();
      paint_channel(*bands[channel], values, bands.size() == 1, static_cast<int>(channel), raster);
    }
    return true;
  }

  void paint_channel(GDALRasterBand& band, const std::vector<float>& values, bool is_only, int channel, RasterUnderlay& raster) const {
    const GDALDataType type = band.GetRasterDataType();
    raster.is_terrain = is_only && (type == GDT_Float32 || type == GDT_Float64 || type == GDT_Int16 || type == GDT_Int32);
    std::vector<std::uint8_t> grey;
    if (raster.is_terrain) {
      grey = shade_heights(values, raster.width_px, raster.height_px, raster.pixel_m);
    } else if (type == GDT_Byte) {
      grey.resize(values.size());
      std::transform(values.begin(), values.end(), grey.begin(), [](float v) { return std::isfinite(v) ? static_cast<std::uint8_t>(std::clamp(std::lround(v), 0L, 255L)) : std::uint8_t{0}; });
    } else {
      grey = stretch_values(values);
    }
    for (std::size_t i = 0; i < grey.size(); ++i) {
      if (!is_only) raster.rgba[4 * i + static_cast<std::size_t>(channel)] = grey[i];
      if (is_only) std::fill_n(raster.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, grey[i]);
      if (!std::isfinite(values[i])) raster.rgba[4 * i + 3] = 0;
    }
  }

  bool paint_palette(GDALRasterBand& band, RasterUnderlay& raster) const {
    std::vector<std::uint16_t> index;
    if (!read_band(band, index, GDT_UInt16, GRIORA_NearestNeighbour, progress_.stage(0.0, 0.8))) return false;
    const GDALColorTable& table = *band.GetColorTable();
    for (std::size_t i = 0; i < index.size(); ++i) {
      GDALColorEntry entry{};
      if (index[i] >= table.GetColorEntryCount() || !table.GetColorEntryAsRGB(index[i], &entry)) continue;
      std::uint8_t* pixel = &raster.rgba[4 * i];
      pixel[0] = static_cast<std::uint8_t>(entry.c1);
      pixel[1] = static_cast<std::uint8_t>(entry.c2);
      pixel[2] = static_cast<std::uint8_t>(entry.c3);
    }
    return true;
  }

  GDALDataset& dataset_;
  const UnderlayRequest& request_;
  const FilePlacement& placement_;
  const Progress& progress_;
  GeoTransform transform_;
  Window window_;
};

}  // namespace

Result<RasterUnderlay> read_raster_underlay(const UnderlayRequest& request, const Progress& progress) {
  const GdalMessages messages;
  progress.at(0.0, "Opening " + std::filesystem::path(request.path).filename().string());
  const DatasetPtr dataset(GDALDataset::Open(request.path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset || dataset->GetRasterCount() == 0) {
    const std::string why = messages.errors().empty() ? "" : ": " + messages.last_error();
    return Result<RasterUnderlay>::failure(error_in(request.path, "no image that can be read" + why, "PNG, JPEG, TIFF and GeoTIFF can be laid under the stems"));
  }
  const auto placement = FilePlacement::of(wkt_of(*dataset), request);
  if (!placement) return Result<RasterUnderlay>::failure(placement.issues);
  Result<RasterUnderlay> result = RasterReading(*dataset, request, *placement, progress).read();
  if (!result && !messages.errors().empty()) result.issues.front().text += " (" + messages.last_error() + ")";
  return result;
}

}  // namespace stemwise
