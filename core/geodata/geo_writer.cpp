#include "core/geodata/geo_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geodata/fleet_map.h"
#include "core/geodata/geo_features.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "core/map/tangent_plane.h"

#ifdef HANDMAP_GDAL
#include <memory>

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>
#include <unistd.h>
#endif

namespace handmap {

namespace {

constexpr std::string_view kBuildingEnding = ".building.yaml";
constexpr std::string_view kFleetEnding = ".fleet.yaml";

bool isNamed(const std::filesystem::path& path, std::string_view ending) {
  return path.filename().string().ends_with(ending);
}

#ifdef HANDMAP_GDAL

/// A file in memory while GDAL writes it.
class FileInMemory {
 public:
  explicit FileInMemory(const std::string& ending)
      : name_(fmt::format("/vsimem/handmap-{}-{}.{}", getpid(), fmt::ptr(this), ending)) {}
  ~FileInMemory() { VSIUnlink(name_.c_str()); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  const char* name() const { return name_.c_str(); }
  std::string content() const {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return bytes == nullptr ? std::string()
                            : std::string(reinterpret_cast<const char*>(bytes), size);
  }

 private:
  std::string name_;
};

class GdalWriter {
 public:
  GdalWriter(const Map& map, std::string file, std::string ending)
      : map_(map), file_(std::move(file)), ending_(std::move(ending)), is_plan_(ending_ == "dxf") {
    if (!is_plan_) plane_.emplace(*map.georeference);
  }

  std::string write() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
    const FileInMemory memory(ending_);
    writeTo(memory.name());
    CPLPopErrorHandler();
    std::string content = memory.content();
    if (content.empty() || !is_well_) {
      throw Error(ErrorCode::RunFailed,
                  phrase("{}: cannot be written: {}", file_, std::string(CPLGetLastErrorMsg())));
    }
    return content;
  }

 private:
  void writeTo(const char* name) {
    const char* driver_name = is_plan_ ? "DXF" : ending_ == "gpkg" ? "GPKG" : "KML";
    GDALDriverH driver = GDALGetDriverByName(driver_name);
    if (driver == nullptr) return void(is_well_ = false);
    GDALDatasetH dataset = GDALCreate(driver, name, 0, 0, 0, GDT_Unknown, nullptr);
    if (dataset == nullptr) return void(is_well_ = false);
    OGRSpatialReferenceH wgs84 = OSRNewSpatialReference(nullptr);
    OSRImportFromEPSG(wgs84, 4326);
    OSRSetAxisMappingStrategy(wgs84, OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayerH layer = GDALDatasetCreateLayer(dataset, is_plan_ ? "entities" : "buildings",
                                             is_plan_ ? nullptr : wgs84,
                                             is_plan_ ? wkbUnknown : wkbPolygon, nullptr);
    OSRDestroySpatialReference(wgs84);
    is_well_ = layer != nullptr;
    if (layer != nullptr && !is_plan_) addFields(layer);
    for (const Building& building : map_.buildings) {
      if (is_well_) is_plan_ ? addToPlan(layer, building) : add(layer, building);
    }
    GDALClose(dataset);
  }

  static void addFields(OGRLayerH layer) {
    const auto field = [&](const char* name, OGRFieldType type) {
      OGRFieldDefnH definition = OGR_Fld_Create(name, type);
      OGR_L_CreateField(layer, definition, TRUE);
      OGR_Fld_Destroy(definition);
    };
    for (const char* name : {"id", "Name", "kind"}) field(name, OFTString);
    for (const char* name : {"sigma_x_m", "sigma_y_m", "sigma_width_m", "doubt"}) {
      field(name, OFTReal);
    }
  }

  /// A plan has a word for being closed in place of the first corner once more.
  OGRGeometryH ringOf(const Building& building) const {
    OGRGeometryH ring = OGR_G_CreateGeometry(wkbLinearRing);
    Polygon outline = building.footprint();
    if (!is_plan_) outline.push_back(outline.front());
    for (const Vec2& corner : outline) {
      const Vec2 at = plane_ ? plane_->longitudeLatitude(corner) : corner;
      OGR_G_AddPoint_2D(ring, at.x(), at.y());
    }
    return ring;
  }

  void add(OGRLayerH layer, const Building& building) {
    OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(layer));
    const auto set = [&](const char* name, const auto& value) {
      const int index = OGR_F_GetFieldIndex(feature, name);
      if (index < 0) return;
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
        OGR_F_SetFieldDouble(feature, index, value);
      } else {
        OGR_F_SetFieldString(feature, index, value.c_str());
      }
    };
    set("id", building.id);
    set("Name", building.name.empty() ? building.id : building.name);
    set("kind", std::string("building"));
    if (const auto& estimate = building.estimate) {
      set("sigma_x_m", estimate->sigma_x);
      set("sigma_y_m", estimate->sigma_y);
      set("sigma_width_m", estimate->sigma_width);
    }
    if (building.doubt) set("doubt", *building.doubt);
    OGRGeometryH polygon = OGR_G_CreateGeometry(wkbPolygon);
    OGR_G_AddGeometryDirectly(polygon, ringOf(building));
    finish(layer, feature, polygon);
  }

  /// Only what has such a style becomes a text, 2 m high.
  static std::string labelOf(const std::string& text) {
    std::string label = "LABEL(f:\"Arial\",s:2g,t:\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') label += '\\';
      label += c;
    }
    return label + "\")";
  }

  /// A closed line on a layer, and the name on another.
  void addToPlan(OGRLayerH layer, const Building& building) {
    const auto create = [&](const char* plan_layer) {
      OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(layer));
      OGR_F_SetFieldString(feature, OGR_F_GetFieldIndex(feature, "Layer"), plan_layer);
      return feature;
    };
    finish(layer, create("BUILDINGS"), ringOf(building));
    OGRFeatureH name = create("NAMES");
    OGR_F_SetStyleString(name,
                         labelOf(building.name.empty() ? building.id : building.name).c_str());
    OGRGeometryH point = OGR_G_CreateGeometry(wkbPoint);
    const Vec2 centre = building.box().centre;
    OGR_G_AddPoint_2D(point, centre.x(), centre.y());
    finish(layer, name, point);
  }

  void finish(OGRLayerH layer, OGRFeatureH feature, OGRGeometryH geometry) {
    OGR_F_SetGeometryDirectly(feature, geometry);
    is_well_ = is_well_ && OGR_L_CreateFeature(layer, feature) == OGRERR_NONE;
    OGR_F_Destroy(feature);
  }

  const Map& map_;
  std::string file_;
  std::string ending_;
  bool is_plan_;
  bool is_well_ = true;
  std::optional<TangentPlane> plane_;
};

#endif

}  // namespace

const std::vector<std::string>& writableEndings() {
  static const std::vector<std::string> kEndings = {"geojson", "osm", "kml", "gpkg", "dxf", "yaml"};
  return kEndings;
}

bool isMapServer(const std::filesystem::path& path) {
  return lowerEnding(path) == "yaml" && !isNamed(path, kBuildingEnding) &&
         !isNamed(path, kFleetEnding);
}

bool needsGeoreference(const std::filesystem::path& path) {
  const std::string ending = lowerEnding(path);
  return ending == "geojson" || ending == "osm" || ending == "kml" || ending == "gpkg";
}

void writeGeoMap(const Map& map, const std::filesystem::path& path) {
  const std::string ending = lowerEnding(path);
  if (std::ranges::find(writableEndings(), ending) == writableEndings().end()) {
    throwBadInput(path.string(), "", phrase("another ending"),
                  fmt::format("{}", fmt::join(writableEndings(), ", ")));
  }
  if (isNamed(path, kBuildingEnding)) return writeFileAtomically(path, formatBuildingYaml(map));
  if (isNamed(path, kFleetEnding)) {
    return writeFileAtomically(path, formatReferenceCoordinates(map, path));
  }
  if (ending == "yaml") return writeRobotMap(map, path);
  if (ending == "geojson") return writeFileAtomically(path, formatGeoJson(map));
  if (ending == "osm") return writeFileAtomically(path, formatOsm(map));
  if (needsGeoreference(path) && !map.georeference) {
    throw Error(ErrorCode::BadInput,
                phrase("georeference: found nothing, expected where the map lies"),
                phrase("give the map a georeference before exporting it as {}", ending));
  }
#ifdef HANDMAP_GDAL
  GDALAllRegister();
  writeFileAtomically(path, GdalWriter(map, path.string(), ending).write());
#else
  throw Error(
      ErrorCode::BadInput,
      phrase("{}: this program was built without GDAL, which writes {}", path.string(), ending));
#endif
}

}  // namespace handmap
