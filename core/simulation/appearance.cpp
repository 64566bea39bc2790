#include "core/simulation/appearance.h"

#include <algorithm>

#include "core/base/random.h"

namespace handmap {

namespace {

constexpr std::uint32_t kAppearance = 10;
constexpr double kHouse_m = 26.0;  // a longer building is no house

// Measured roughly from what towns are painted with; each is varied.
constexpr Reflectance kPlaster[] = {
    {0.72F, 0.70F, 0.64F}, {0.66F, 0.58F, 0.42F}, {0.62F, 0.50F, 0.30F}, {0.52F, 0.52F, 0.50F},
    {0.60F, 0.40F, 0.28F}, {0.45F, 0.50F, 0.52F}, {0.50F, 0.30F, 0.22F}, {0.34F, 0.36F, 0.30F}};
constexpr Reflectance kBrick[] = {
    {0.27F, 0.12F, 0.08F}, {0.33F, 0.19F, 0.12F}, {0.40F, 0.30F, 0.19F}, {0.20F, 0.13F, 0.11F}};
constexpr Reflectance kPanel[] = {
    {0.42F, 0.41F, 0.39F}, {0.55F, 0.54F, 0.51F}, {0.33F, 0.32F, 0.31F}, {0.47F, 0.43F, 0.36F}};
constexpr Reflectance kTrim[] = {
    {0.75F, 0.75F, 0.73F}, {0.70F, 0.68F, 0.62F}, {0.10F, 0.07F, 0.05F}, {0.07F, 0.08F, 0.09F}};
constexpr Reflectance kShutter[] = {{0.06F, 0.12F, 0.07F},
                                    {0.20F, 0.07F, 0.05F},
                                    {0.12F, 0.09F, 0.06F},
                                    {0.10F, 0.14F, 0.20F},
                                    {0.45F, 0.44F, 0.42F}};
constexpr Reflectance kTile[] = {
    {0.28F, 0.11F, 0.07F}, {0.20F, 0.10F, 0.08F}, {0.09F, 0.09F, 0.10F}, {0.15F, 0.12F, 0.10F}};

template <std::size_t Count>
Reflectance oneOf(const Reflectance (&palette)[Count], RandomStream& random) {
  Reflectance colour = palette[random.index(Count)];
  const double bright = random.uniform(0.8, 1.2);
  for (float& share : colour) {
    share = static_cast<float>(
        std::clamp(static_cast<double>(share) * bright * random.uniform(0.94, 1.06), 0.02, 0.85));
  }
  return colour;
}

void chooseWindows(Appearance& look, bool house, RandomStream& random) {
  look.bay_m = random.uniform(house ? 2.4 : 2.6, house ? 3.8 : 4.4);
  look.window_width_m = random.uniform(0.32, 0.55) * look.bay_m;
  look.window_height_m = random.uniform(1.15, 1.75);
  look.sill_m = random.uniform(0.75, 0.95);
  look.trim_m = random.uniform(0.05, 0.18);
  look.shutters = house && random.uniform() < 0.3 && look.window_width_m < 0.45 * look.bay_m;
  look.ribbon = !house && random.uniform() < 0.3;
}

}  // namespace

Appearance appearanceOf(const World& world, std::size_t building) {
  RandomStream random(world.seed, static_cast<std::uint32_t>(building), 0, kAppearance);
  const Rectangle box = world.map.buildings[building].box();
  const bool rectangle = std::holds_alternative<Rectangle>(world.map.buildings[building].shape);
  const bool house = std::max(box.width, box.depth) < kHouse_m;
  Appearance look;
  const double finish = random.uniform();
  look.finish = finish < (house ? 0.65 : 0.4)   ? Appearance::Finish::Plaster
                : finish < (house ? 1.0 : 0.75) ? Appearance::Finish::Brick
                                                : Appearance::Finish::Panels;
  look.wall = look.finish == Appearance::Finish::Plaster ? oneOf(kPlaster, random)
              : look.finish == Appearance::Finish::Brick ? oneOf(kBrick, random)
                                                         : oneOf(kPanel, random);
  look.trim = oneOf(kTrim, random);
  look.shutter = oneOf(kShutter, random);
  look.roof_tile = oneOf(kTile, random);
  look.storeys = house ? 1 + random.index(3) : 2 + random.index(4);
  if (house && look.storeys == 1 && random.uniform() < 0.6) look.storeys = 2;
  look.storey_m = random.uniform(2.6, house ? 3.1 : 3.6);
  look.plinth_m = random.uniform(0.2, 0.7);
  look.weathering = random.uniform(0.05, 0.22);
  chooseWindows(look, house, random);
  const double roof = random.uniform();
  look.roof_pitch_rad = toRadians(random.uniform(25.0, 45.0));
  if (rectangle && roof < (house ? 0.9 : 0.3)) {
    look.roof = roof < (house ? 0.6 : 0.1) ? Appearance::Roof::Gable : Appearance::Roof::Hip;
  }
  return look;
}

}  // namespace handmap
