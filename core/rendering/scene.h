// A world as it is seen from near one place at one time: surfaces, ground, sky and light.
#pragma once

#include "core/rendering/ground_map.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/render_options.h"
#include "core/rendering/sky.h"
#include "core/rendering/sun_map.h"
#include "core/rendering/view_camera.h"

namespace handmap {

class Scene {
 public:
  Scene(const World& world, const Light& light, const Vec2& centre, double time_s);

  const Model& model() const { return model_; }
  /// Radiance that reaches the camera along the ray of pixel (u, v) from a surface (or from the
  /// ground or the sky, see Visibility).
  Colour radiance(std::int32_t seen, const ViewCamera& camera, double u, double v) const;
  Label labelAt(std::int32_t seen, const ViewCamera& camera, double u, double v) const;

 private:
  void addBuildings(const World& world, const Vec2& centre);
  void addThings(const World& world, const Vec2& centre);
  void addPlants(const World& world, const Vec2& centre);
  Colour lit(const Colour& reflectance, const Vec3& point, const Vec3& normal) const;
  Colour surfaceRadiance(const Surface& surface, const ViewCamera& camera, double u,
                         double v) const;
  Colour groundRadiance(const ViewCamera& camera, double u, double v) const;

  Vec3 to_sun_;
  float sun_;
  Model model_;
  GroundMap ground_;
  SunMap sun_map_;
  Sky sky_;
};

}  // namespace handmap
