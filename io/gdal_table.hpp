#pragma once
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "core/base/fingerprint.hpp"
#include "io/gdal_dataset.hpp"

namespace stemwise {

// Only for .cpp files of io: names GDAL. Plain tables of a GeoPackage by a schema that writer and reader share.

struct TableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct TableField {
  const char* name;
  OGRFieldType type;
};

/// Appends rows to a new table, and what they say to a fingerprint. Throws TableError when the disk does not take them.
class TableWriter {
 public:
  TableWriter(GDALDataset& dataset, const char* name, std::span<const TableField> schema, Fingerprint& fingerprint) : fingerprint_(fingerprint) {
    fingerprint_.add(name);
    layer_ = dataset.CreateLayer(name, nullptr, wkbNone, nullptr);
    if (layer_ == nullptr) throw TableError(std::string("table ") + name + " cannot be made");
    for (const TableField& f : schema) {
      OGRFieldDefn field(f.name, f.type);
      if (layer_->CreateField(&field) != OGRERR_NONE) throw TableError(std::string("column ") + f.name + " cannot be made");
    }
    feature_ = std::make_unique<OGRFeature>(layer_->GetLayerDefn());
  }

  void set(int i, std::int64_t v) {
    fingerprint_.add(bytes_of(v));
    feature_->SetField(i, static_cast<GIntBig>(v));
  }
  void set(int i, int v) { set(i, static_cast<std::int64_t>(v)); }
  void set(int i, bool v) { set(i, static_cast<std::int64_t>(v ? 1 : 0)); }
  void set(int i, double v) {
    fingerprint_.add(bytes_of(v));
    feature_->SetField(i, v);
  }
  void set(int i, const std::string& v) {
    fingerprint_.add(v);
    feature_->SetField(i, v.c_str());
  }
  void set(int i, const char* v) { set(i, std::string(v)); }
  /// Not inlined: GCC 12 wrongly takes the value of an empty optional for read.
  template <class T>
  [[gnu::noinline]] void set(int i, const std::optional<T>& v) {
    if (v) return set(i, *v);
    fingerprint_.add("nothing");
    feature_->SetFieldNull(i);
  }
  /// The values in the order of the schema, as one row.
  template <class... Values>
  void row(const Values&... values) {
    feature_->Reset();
    int i = 0;
    (set(i++, values), ...);
    if (layer_->CreateFeature(feature_.get()) != OGRERR_NONE) throw TableError(std::string("a row of ") + layer_->GetName() + " cannot be written");
    ++rows_;
  }
  std::int64_t rows() const { return rows_; }

 private:
  template <class Number>
  static std::string bytes_of(Number value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  }

  OGRLayer* layer_ = nullptr;
  std::unique_ptr<OGRFeature> feature_;
  std::int64_t rows_ = 0;
  Fingerprint& fingerprint_;
};

/// Reads a table row by row; columns by their place in the schema. Throws TableError when it or a column is missing.
class TableReader {
 public:
  TableReader(GDALDataset& dataset, const char* name, std::span<const TableField> schema) : layer_(dataset.GetLayerByName(name)) {
    if (layer_ == nullptr) throw TableError(std::string("table ") + name + " is missing");
    for (const TableField& f : schema) {
      const int at = layer_->GetLayerDefn()->GetFieldIndex(f.name);
      if (at < 0) throw TableError(std::string("table ") + name + " has no column " + f.name);
      column_.push_back(at);
    }
    layer_->ResetReading();
  }
  bool next() {
    feature_.reset(layer_->GetNextFeature());
    rows_ += feature_ ? 1 : 0;
    return feature_ != nullptr;
  }
  bool is_null(int i) const { return !feature_->IsFieldSetAndNotNull(column_[static_cast<std::size_t>(i)]); }
  std::int64_t integer(int i) const { return feature_->GetFieldAsInteger64(column_[static_cast<std::size_t>(i)]); }
  double real(int i) const { return feature_->GetFieldAsDouble(column_[static_cast<std::size_t>(i)]); }
  std::string text(int i) const { return is_null(i) ? std::string() : feature_->GetFieldAsString(column_[static_cast<std::size_t>(i)]); }
  std::optional<double> optional_real(int i) const { return is_null(i) ? std::nullopt : std::optional(real(i)); }
  std::optional<std::int64_t> optional_integer(int i) const { return is_null(i) ? std::nullopt : std::optional(integer(i)); }
  std::int64_t rows() const { return rows_; }

 private:
  OGRLayer* layer_ = nullptr;
  std::vector<int> column_;
  FeaturePtr feature_;
  std::int64_t rows_ = 0;
};

}  // namespace stemwise
