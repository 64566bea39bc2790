#include "core/geodata/geo_map.h"

#include <algorithm>
#include <functional>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/geodata/geo_features.h"
#include "core/map/map_limits.h"
#include "core/map/tangent_plane.h"

namespace handmap {

namespace {

/// From a public map: as sure as a plan, true to scale and turned rightly.
constexpr Uncertainty kPublicUncertainty{0.5, 0.5};

/// From what the file has, degrees or metres.
using InMap = std::function<Vec2(const Vec2&)>;

Polygon corners(const InMap& in_map, const std::vector<Vec2>& ring) {
  Polygon outline;
  for (const Vec2& point : ring) outline.push_back(in_map(point));
  if (outline.size() > 1 && (outline.front() - outline.back()).norm() < 1e-6) outline.pop_back();
  if (signedArea(outline) < 0.0) std::ranges::reverse(outline);
  return outline;
}

bool canBeDrawn(const Polygon& outline) {
  const bool near = std::ranges::all_of(outline, [](const Vec2& corner) {
    return corner.allFinite() && corner.cwiseAbs().maxCoeff() <= kMaxCoordinate;
  });
  return near && outline.size() >= 3 && outline.size() <= kMaxPolygonVertices &&
         signedArea(outline) > kMinPolygonArea && isSimple(outline);
}

/// The middle of what is there, as the file has it.
Vec2 middleOf(const std::vector<GeoFeature>& features) {
  Vec2 low = features.front().points.front();
  Vec2 high = low;
  for (const GeoFeature& feature : features) {
    for (const Vec2& point : feature.points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  return 0.5 * (low + high);
}

/// Plans have an origin of their own, or count from that of a country: then they are moved by whole
/// metres to where a drawing can lie.
Vec2 originOf(const Vec2& middle) {
  const bool is_far = middle.cwiseAbs().maxCoeff() > 0.1 * kMaxCoordinate;
  return is_far ? Vec2(middle.array().round()) : Vec2(0.0, 0.0);
}

class Ids {
 public:
  /// The wanted one, or the next that is free.
  std::string take(const std::string& wanted, char prefix) {
    std::string id = wanted;
    while (id.empty() || !taken_.insert(id).second) id = prefix + std::to_string(next_++);
    return id;
  }

 private:
  std::unordered_set<std::string> taken_{"@start", "@route"};
  int next_ = 1;
};

void addBuilding(GeoMap& geo, const InMap& in_map, const GeoFeature& feature, Ids& ids) {
  Polygon outline = corners(in_map, feature.points);
  if (!canBeDrawn(outline) || geo.map.buildings.size() == kMaxBuildings) {
    ++geo.left_out;
    return;
  }
  Building building;
  building.id = ids.take(feature.id, 'B');
  building.name = feature.name;
  building.shape = std::move(outline);
  building.uncertainty = feature.uncertainty;
  keepTags(feature.tags, building);
  geo.map.buildings.push_back(std::move(building));
}

/// Of a plan: by the texts in their outlines.
void nameByTexts(std::vector<GeoFeature>& features) {
  for (const GeoFeature& text : features) {
    if (text.kind != GeoKind::Other || text.name.empty()) continue;
    for (GeoFeature& feature : features) {
      const bool is_outline = feature.kind == GeoKind::Building || feature.kind == GeoKind::Area;
      if (is_outline && feature.name.empty() && contains(feature.points, text.points.front())) {
        feature.name = text.name;
      }
    }
  }
}

}  // namespace

const std::vector<std::string>& geoFileEndings() {
  static const std::vector<std::string> kEndings = {"geojson", "json", "osm", "gpkg",
                                                    "shp",     "kml",  "gml", "dxf"};
  return kEndings;
}

bool isGeoFile(const std::filesystem::path& path) {
  return std::ranges::find(geoFileEndings(), lowerEnding(path)) != geoFileEndings().end();
}

GeoMap readGeoMap(const std::filesystem::path& path) {
  std::vector<GeoFeature> features = readGeoFeatures(path);
  std::erase_if(features, [](const GeoFeature& feature) { return feature.points.empty(); });
  const bool is_plan = isPlan(path);
  if (is_plan) nameByTexts(features);
  const bool tells_kinds = std::ranges::any_of(
      features, [](const GeoFeature& feature) { return feature.kind == GeoKind::Building; });
  if (!tells_kinds)
    for (GeoFeature& feature : features)
      if (feature.kind == GeoKind::Area) feature.kind = GeoKind::Building;
  const std::size_t all = features.size();
  std::erase_if(features, [](const GeoFeature& feature) {
    return feature.kind == GeoKind::Area || feature.kind == GeoKind::Other;
  });
  if (std::ranges::none_of(
          features, [](const GeoFeature& feature) { return feature.kind == GeoKind::Building; })) {
    throwBadInput(path.string(), {}, phrase("{} features and no building among them", all),
                  phrase("polygons of buildings"));
  }
  GeoMap geo;
  const Vec2 middle = middleOf(features);
  const Georeference on_earth{
      std::clamp(middle.y(), -kMaxLatitudeDeg, kMaxLatitudeDeg), middle.x(), 0.0, {}};
  if (!is_plan) geo.map.georeference = on_earth;
  geo.map.uncertainty = kPublicUncertainty;
  geo.map.whole = {0.0, 0.0};
  const TangentPlane plane(on_earth);
  const Vec2 origin = originOf(middle);
  const InMap in_map = [&](const Vec2& point) {
    return is_plan ? Vec2(point - origin) : plane.inMap(point);
  };
  Ids ids;
  for (const GeoFeature& feature : features) {
    if (feature.kind == GeoKind::Building) {
      addBuilding(geo, in_map, feature, ids);
    } else if (feature.kind == GeoKind::Landmark && geo.map.landmarks.size() < kMaxLandmarks) {
      geo.map.landmarks.push_back(
          {ids.take(feature.id, 'L'), feature.name, plane.inMap(feature.points.front())});
    } else if (feature.kind == GeoKind::Route && geo.map.route.empty()) {
      for (const Vec2& point : feature.points) geo.map.route.push_back(plane.inMap(point));
    }
  }
  if (geo.map.buildings.empty())
    throwBadInput(path.string(), {},
                  phrase("{} outlines that cross themselves or are too large", geo.left_out),
                  phrase("polygons of buildings"));
  return geo;
}

}  // namespace handmap
