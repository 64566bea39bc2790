#include "core/geodata/geo_features.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/geodata/osm_tags.h"

#ifdef HANDMAP_GDAL
#include <array>
#include <memory>
#include <mutex>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <nlohmann/json.hpp>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "core/base/json.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"
#endif

namespace handmap {

#ifdef HANDMAP_GDAL

namespace {

/// Those of geoFileEndings(): no other one is tried on a file that says it is one of these.
constexpr const char* kDrivers[] = {"GeoJSON", "OSM", "GPKG", "ESRI Shapefile", "KML",
                                    "LIBKML",  "GML", "DXF",  nullptr};

/// Nothing is left beside what is read, and nothing fetched for it.
constexpr const char* kAloneGml[] = {"WRITE_GFS=NO", "DOWNLOAD_SCHEMA=NO", nullptr};

struct CloseDataset {
  void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
struct DestroyFeature {
  void operator()(OGRFeatureH feature) const { OGR_F_Destroy(feature); }
};
struct DestroyTransformation {
  void operator()(OGRCoordinateTransformationH transformation) const {
    OCTDestroyCoordinateTransformation(transformation);
  }
};
using Dataset = std::unique_ptr<void, CloseDataset>;
using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, DestroyFeature>;
using Transformation =
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, DestroyTransformation>;

constexpr std::size_t kMostTags = 1000;
constexpr std::uintmax_t kMostJsonBytes = 64u << 20;

/// What GDAL says is part of our message, and nothing for the terminal.
class QuietErrors {
 public:
  QuietErrors() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~QuietErrors() { CPLPopErrorHandler(); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
};

std::string textOf(OGRFeatureH feature, std::initializer_list<const char*> fields) {
  for (const char* field : fields) {
    const int index = OGR_F_GetFieldIndex(feature, field);
    if (index < 0 || !OGR_F_IsFieldSetAndNotNull(feature, index)) continue;
    std::string text = OGR_F_GetFieldAsString(feature, index);
    if (!text.empty()) return text.substr(0, kMaxTextBytes);
  }
  return {};
}

std::optional<double> numberOf(OGRFeatureH feature, const char* field) {
  const int index = OGR_F_GetFieldIndex(feature, field);
  if (index < 0 || !OGR_F_IsFieldSetAndNotNull(feature, index)) return std::nullopt;
  const double number = OGR_F_GetFieldAsDouble(feature, index);
  return number >= 0.0 && number <= kMaxSigma ? std::optional(number) : std::nullopt;
}

/// All that a public map says of a feature; none where this program wrote it without any.
PublicTags publicTagsOf(OGRFeatureH feature) {
  constexpr std::array<std::string_view, 8> kOwn = {
      "kind", "sigma_position_m", "sigma_size_m", "id", "@id", "osm_id", "osm_way_id", "doubt"};
  PublicTags tags;
  const std::string address = textOf(feature, {"@id"});  // "way/123", of Overpass and this program
  const std::size_t slash = address.find('/');
  const std::string way = textOf(feature, {"osm_way_id"});
  const std::string relation = textOf(feature, {"osm_id"});
  if (slash != std::string::npos) {
    tags.osm_type = address.substr(0, slash);
    tags.osm_id = address.substr(slash + 1);
  } else if (!way.empty() || !relation.empty()) {
    tags.osm_type = way.empty() ? "relation" : "way";
    tags.osm_id = way.empty() ? relation : way;
  }
  for (int i = 0; i < OGR_F_GetFieldCount(feature); ++i) {
    if (!OGR_F_IsFieldSetAndNotNull(feature, i) || tags.tags.size() >= kMostTags) continue;
    const std::string name = OGR_Fld_GetNameRef(OGR_F_GetFieldDefnRef(feature, i));
    const std::string value =
        std::string(OGR_F_GetFieldAsString(feature, i)).substr(0, kMaxTextBytes);
    if (name == "other_tags") {
      addPackedTags(value, tags.tags);
    } else if (std::ranges::find(kOwn, name) == kOwn.end() && !name.starts_with("estimate_") &&
               !value.empty()) {
      tags.tags[name] = value;
    }
  }
  const bool is_own = textOf(feature, {"kind"}) == "building" && tags.osm_type.empty();
  return is_own ? PublicTags() : tags;
}

std::vector<Vec2> pointsOf(OGRGeometryH line) {
  std::vector<Vec2> points;
  for (int i = 0; i < OGR_G_GetPointCount(line); ++i)
    points.emplace_back(OGR_G_GetX(line, i), OGR_G_GetY(line, i));
  return points;
}

/// A plan has closed lines and, as this program writes it, names in another layer.
GeoKind kindInPlan(OGRFeatureH feature, OGRwkbGeometryType type, const std::vector<Vec2>& points) {
  const bool is_closed = points.size() > 3 && (points.front() - points.back()).norm() < 1e-6;
  if (type != wkbPolygon && !(type == wkbLineString && is_closed)) return GeoKind::Other;
  return textOf(feature, {"Layer"}) == "BUILDINGS" ? GeoKind::Building : GeoKind::Area;
}

GeoKind kindOf(OGRFeatureH feature, OGRwkbGeometryType type) {
  const std::string own = textOf(feature, {"kind"});  // what this program exports
  if (own == "landmark" && type == wkbPoint) return GeoKind::Landmark;
  if (own == "route" && type == wkbLineString) return GeoKind::Route;
  if (type != wkbPolygon) return GeoKind::Other;
  const std::string building = textOf(feature, {"building"});
  if (own == "building" || (!building.empty() && building != "no")) return GeoKind::Building;
  return GeoKind::Area;
}

/// Editors of OpenStreetMap write nodes in any order, and give what was drawn anew numbers below 0:
/// GDAL's quicker index takes neither.
class AnyNumbers {
 public:
  AnyNumbers() { CPLSetThreadLocalConfigOption("OSM_USE_CUSTOM_INDEXING", "NO"); }
  ~AnyNumbers() { CPLSetThreadLocalConfigOption("OSM_USE_CUSTOM_INDEXING", nullptr); }
  AnyNumbers(const AnyNumbers&) = delete;
  AnyNumbers& operator=(const AnyNumbers&) = delete;
};

class Reader {
 public:
  Reader(std::string file, bool is_plan) : file_(std::move(file)), is_plan_(is_plan) {}

  std::vector<GeoFeature> read() {
    const QuietErrors quiet;
    CPLErrorReset();
    const AnyNumbers any_numbers;
    const bool is_gml = lowerEnding(file_) == "gml";
    const Dataset dataset(GDALOpenEx(file_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, kDrivers,
                                     is_gml ? kAloneGml : nullptr, nullptr));
    if (!dataset) refuse(phrase("no geographic data"));
    GDALDatasetResetReading(dataset.get());
    OGRLayerH layer = nullptr;
    while (const Feature feature{
        GDALDatasetGetNextFeature(dataset.get(), &layer, nullptr, nullptr, nullptr)})
      take(feature.get(), layer);
    if (CPLGetLastErrorType() >= CE_Failure) refuse(phrase("damaged geographic data"));
    return std::move(features_);
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    std::string details = CPLGetLastErrorMsg();
    if (details.starts_with("./")) details.erase(0, details.find(": ") + 2);  // where in GDAL
    namePlaceInJson();
    throwBadInput(file_, {}, details.empty() ? found : found + " (" + details + ")",
                  phrase("GeoJSON, OpenStreetMap XML, GeoPackage, Shapefile, KML, GML or DXF"));
  }

  /// GDAL does not say where a GeoJSON is damaged: who reads JSON here does.
  void namePlaceInJson() const {
    const std::string ending = lowerEnding(file_);
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file_, error);
    if ((ending != "geojson" && ending != "json") || error || bytes > kMostJsonBytes) return;
    parseJson(readFile(file_, kMostJsonBytes), file_);
  }

  /// To longitude and latitude, in this order whatever the authority says.
  void toDegrees(OGRGeometryH geometry, OGRLayerH layer) {
    if (layer != layer_) {
      layer_ = layer;
      transformation_.reset();
      const OGRSpatialReferenceH from = OGR_L_GetSpatialRef(layer);
      OGRSpatialReferenceH wgs84 = OSRNewSpatialReference(nullptr);
      OSRImportFromEPSG(wgs84, 4326);
      OSRSetAxisMappingStrategy(wgs84, OAMS_TRADITIONAL_GIS_ORDER);
      if (from != nullptr && !OSRIsSame(from, wgs84))
        transformation_.reset(OCTNewCoordinateTransformation(from, wgs84));
      OSRDestroySpatialReference(wgs84);
    }
    if (transformation_ && OGR_G_Transform(geometry, transformation_.get()) != OGRERR_NONE)
      refuse(phrase("coordinates that lie nowhere on earth"));
  }

  void take(OGRFeatureH feature, OGRLayerH layer) {
    OGRGeometryH geometry = OGR_F_GetGeometryRef(feature);
    if (geometry == nullptr) return;
    GeoFeature found;
    if (is_plan_) {
      found.name = textOf(feature, {"Text"});
      return add(feature, geometry, found);
    }
    toDegrees(geometry, layer);
    found.id = textOf(feature, {"id", "osm_way_id", "osm_id", "@id"});
    found.name = textOf(feature, {"name"});
    found.tags = publicTagsOf(feature);
    const auto position = numberOf(feature, "sigma_position_m");
    const auto size = numberOf(feature, "sigma_size_m");
    if (position && size) found.uncertainty = Uncertainty{*position, *size};
    const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(geometry));
    const bool several = type == wkbMultiPolygon || type == wkbGeometryCollection;
    if (!several) return add(feature, geometry, found);
    for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i)
      add(feature, OGR_G_GetGeometryRef(geometry, i), found);
  }

  void add(OGRFeatureH feature, OGRGeometryH geometry, GeoFeature found) {
    const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(geometry));
    const bool has_ring = type == wkbPolygon && OGR_G_GetGeometryCount(geometry) > 0;
    if (type == wkbPolygon && !has_ring) return;
    found.points = pointsOf(has_ring ? OGR_G_GetGeometryRef(geometry, 0) : geometry);
    found.kind = is_plan_ ? kindInPlan(feature, type, found.points) : kindOf(feature, type);
    for (const Vec2& point : found.points) {
      if (is_plan_) break;
      if (std::abs(point.x()) <= 180.0 && std::abs(point.y()) <= 90.0) continue;
      throwBadInput(file_, {}, phrase("the coordinates {}, {}", point.x(), point.y()),
                    phrase("longitude and latitude in degrees"));
    }
    features_.push_back(std::move(found));
  }

  std::string file_;
  bool is_plan_;  ///< in metres of nobody knows where
  std::vector<GeoFeature> features_;
  OGRLayerH layer_ = nullptr;
  Transformation transformation_;
};

}  // namespace

std::vector<GeoFeature> readGeoFeatures(const std::filesystem::path& path) {
  static std::once_flag registered;
  std::call_once(registered, [] { GDALAllRegister(); });
  if (!std::filesystem::is_regular_file(path))
    throwBadInput(path.string(), {}, phrase("no file"), phrase("a file of geographic data"));
  std::vector<GeoFeature> features = Reader(path.string(), isPlan(path)).read();
  if (lowerEnding(path) == "osm") takeAllTags(path, features);
  return features;
}

#else

std::vector<GeoFeature> readGeoFeatures(const std::filesystem::path& path) {
  throw Error(ErrorCode::BadInput,
              phrase("{}: this program was built without GDAL, which reads geographic data",
                     path.string()));
}

#endif

std::string lowerEnding(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending;
}

bool isPlan(const std::filesystem::path& path) { return lowerEnding(path) == "dxf"; }

}  // namespace handmap
