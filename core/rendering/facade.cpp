#include "core/rendering/facade.h"

#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr float kBrickLength_m = 0.25F;
constexpr float kBrickHeight_m = 0.0833F;
constexpr float kDoorHeight_m = 2.2F;
constexpr float kDoorHalf_m = 0.55F;
constexpr float kPipe_m = 0.09F;

Colour mixed(const Colour& a, const Colour& b, float share) { return a + share * (b - a); }

/// A rectangle of the wall: how much of the pixel it covers.
struct Box {
  float left;
  float right;
  float bottom;
  float top;
  float covers(float x, float y, const TexturePoint& at) const {
    return coverage(x, left, right, at.du) * coverage(y, bottom, top, at.dv);
  }
  Box grown(float by) const { return {left - by, right + by, bottom - by, top + by}; }
};

/// Stains of all sizes, so that also plaster has something to match.
float stains(const Surface& wall, const TexturePoint& at, float contrast) {
  const float pixel = std::max(at.du, at.dv);
  return contrast * (0.5F * grain(at.u, at.v, 0.05F, pixel, wall.seed + 1) +
                     0.7F * grain(at.u, at.v, 0.22F, pixel, wall.seed + 2) +
                     0.9F * grain(at.u, at.v, 0.9F, pixel, wall.seed + 3) +
                     0.9F * grain(at.u, at.v, 3.7F, pixel, wall.seed + 4) +
                     // rain runs down
                     0.6F * grain(at.u, 0.07F * at.v, 0.3F, at.du, wall.seed + 5));
}

Colour bare(const Surface& wall, const Appearance& look, const TexturePoint& at) {
  Colour colour = wall.colour;
  const auto contrast = static_cast<float>(look.weathering);
  const float pixel = std::max(at.du, at.dv);
  if (look.finish == Appearance::Finish::Brick) {
    const int row = floorOf(at.v / kBrickHeight_m);
    const float x = at.u + (row % 2 == 0 ? 0.0F : kBrickLength_m / 2.0F);
    const float own = randomAt(floorOf(x / kBrickLength_m), row, wall.seed + 6) - 0.5F;
    const float joints = std::max(stripes(at.v, kBrickHeight_m, 0.13F, at.dv),
                                  stripes(x, kBrickLength_m, 0.05F, at.du));
    colour *= 1.0F + 0.6F * own * visible(kBrickLength_m, pixel);
    colour = mixed(colour, Colour(0.36F, 0.33F, 0.29F), 0.8F * joints);
  } else if (look.finish == Appearance::Finish::Panels) {
    const auto bay = static_cast<float>(look.bay_m);
    const auto storey = static_cast<float>(look.storey_m);
    const float joints =
        std::max(stripes(at.u, bay, 0.012F, at.du), stripes(at.v, storey, 0.012F, at.dv));
    const float own = randomAt(floorOf(at.u / bay), floorOf(at.v / storey), wall.seed + 7) - 0.5F;
    colour *= (1.0F + 0.14F * own) * (1.0F - 0.6F * joints);
  }
  return colour * (1.0F + stains(wall, at, contrast));
}

/// Glass: dark rooms, curtains, and a bright reflection of the sky.
Colour glass(const Surface& wall, int bay, int storey, const Box& pane, float x, float y,
             const TexturePoint& at) {
  const auto chance = [&](std::uint32_t purpose) {
    return randomAt(bay, storey * 16 + static_cast<int>(purpose), wall.seed + 8);
  };
  const float up = (y - pane.bottom) / (pane.top - pane.bottom);
  const float pixel = std::max(at.du, at.dv);
  const float shine = 0.03F + 0.22F * chance(0) * chance(0) * (0.4F + 0.6F * up);
  const float mirrored =
      1.0F + 0.7F * grain(at.u + 3.0F * chance(1), at.v, 0.35F, pixel, wall.seed + 9);
  Colour colour = Colour(0.85F, 0.95F, 1.05F) * (shine * mirrored);
  const float kind = chance(2);
  const float width = pane.right - pane.left;
  const Colour cloth(0.42F, 0.41F, 0.38F);
  if (kind < 0.3F) {  // curtains on both sides
    const float drawn = width * (0.12F + 0.2F * chance(3));
    const float folds = 1.0F + 0.25F * grain(at.u, 0.0F, 0.07F, at.du, wall.seed + 10);
    const float hidden = 1.0F - coverage(x, pane.left + drawn, pane.right - drawn, at.du);
    colour = mixed(colour, cloth * folds, hidden);
  } else if (kind < 0.55F) {  // a blind, partly down
    const float end = pane.top - (pane.top - pane.bottom) * (0.15F + 0.8F * chance(3));
    const float slats = 1.0F - 0.25F * stripes(at.v, 0.06F, 0.3F, at.dv);
    colour = mixed(colour, cloth * slats, coverage(y, end, pane.top, at.dv));
  }
  const float recess = coverage(y, pane.top - 0.12F, pane.top, at.dv);
  return colour * (1.0F - 0.55F * recess);
}

class Drawing {
 public:
  Drawing(const Surface& wall, const Facade& facade, const TexturePoint& at)
      : wall_(wall), facade_(facade), look_(facade.look), at_(at) {}

  Colour draw() {
    colour_ = bare(wall_, look_, at_);
    const auto plinth = static_cast<float>(look_.plinth_m);
    colour_ *= 1.0F - 0.45F * coverage(at_.v, -1.0F, plinth, at_.dv);
    drawEaves();
    drawPipe();
    const auto bay_m = static_cast<float>(look_.bay_m);
    const auto storey_m = static_cast<float>(look_.storey_m);
    const int bay = floorOf((at_.u - facade_.margin_m) / bay_m);
    const int storey = floorOf((at_.v - plinth) / storey_m);
    if (bay < 0 || bay >= facade_.bays) return colour_;
    const float x = at_.u - facade_.margin_m - (static_cast<float>(bay) + 0.5F) * bay_m;
    if (bay == facade_.door_bay && storey <= 0) {
      drawDoor(x);
    } else if (storey >= 0 && storey < look_.storeys) {
      drawWindow(bay, storey, x, at_.v - plinth - static_cast<float>(storey) * storey_m);
    }
    return colour_;
  }

 private:
  void drawEaves() {
    const float top = facade_.eaves_m;
    if (look_.roof == Appearance::Roof::Flat) {
      colour_ = mixed(colour_, colourOf(look_.trim) * 0.8F,
                      0.9F * coverage(at_.v, top - 0.3F, top, at_.dv));
      return;
    }
    if (facade_.gable) return;
    if (at_.v < top) colour_ *= 1.0F - 0.5F * std::max(0.0F, 1.0F - (top - at_.v) / 0.7F);
  }

  void drawPipe() {
    if (randomAt(1, 2, wall_.seed) < 0.4F || at_.v > facade_.eaves_m) return;
    const float pipe = coverage(at_.u, 0.2F, 0.2F + kPipe_m, at_.du);
    const float shade = coverage(at_.u, 0.2F + kPipe_m, 0.25F + kPipe_m, at_.du);
    colour_ = mixed(colour_, Colour(0.2F, 0.19F, 0.18F), pipe) * (1.0F - 0.35F * shade);
  }

  void drawDoor(float x) {
    const Box door{-kDoorHalf_m, kDoorHalf_m, -1.0F, kDoorHeight_m};
    const float y = at_.v;
    colour_ = mixed(colour_, colourOf(look_.trim), door.grown(0.12F).covers(x, y, at_));
    const float boards = 1.0F - 0.3F * stripes(x + 10.0F, 0.37F, 0.1F, at_.du);
    colour_ = mixed(colour_, colourOf(look_.shutter) * boards, door.covers(x, y, at_));
    const Box light{-0.25F, 0.25F, 1.45F, 2.0F};
    colour_ = mixed(colour_, Colour(0.08F, 0.09F, 0.1F), light.covers(x, y, at_));
  }

  void drawWindow(int bay, int storey, float x, float y) {
    const auto bay_m = static_cast<float>(look_.bay_m);
    const float half =
        look_.ribbon ? 0.5F * bay_m : 0.5F * static_cast<float>(look_.window_width_m);
    const auto sill = static_cast<float>(look_.sill_m);
    const Box hole{-half, half, sill, sill + static_cast<float>(look_.window_height_m)};
    if (!look_.ribbon && randomAt(bay, storey, wall_.seed + 12) < 0.06F) return;  // none here
    if (look_.shutters) drawShutters(hole, x, y);
    const auto trim = static_cast<float>(look_.trim_m);
    const Colour frame = colourOf(look_.trim);
    colour_ = mixed(colour_, frame, hole.grown(trim).covers(x, y, at_));
    const Box shade{-half - 0.1F, half + 0.1F, sill - 0.2F, sill - trim};
    colour_ *= 1.0F - 0.35F * shade.covers(x, y, at_);  // below the sill
    const float inside = hole.covers(x, y, at_);
    if (inside == 0.0F) return;
    const Colour pane = glass(wall_, bay, storey, hole, x, y, at_);
    const int lights = half > 0.9F ? 3 : half > 0.45F ? 2 : 1;
    const float width = 2.0F * half / static_cast<float>(lights);
    const float bars = stripes(x + half + 0.035F, width, 0.07F / width, at_.du);
    colour_ = mixed(colour_, mixed(pane, 0.9F * frame, bars), inside);
  }

  void drawShutters(const Box& hole, float x, float y) {
    const float width = 0.45F * (hole.right - hole.left);
    const Colour slats =
        colourOf(look_.shutter) * (1.0F - 0.35F * stripes(at_.v, 0.07F, 0.4F, at_.dv));
    for (const float side : {-1.0F, 1.0F}) {
      const float near = hole.right + static_cast<float>(look_.trim_m);
      const Box shutter{side > 0 ? near : -near - width, side > 0 ? near + width : -near,
                        hole.bottom, hole.top};
      colour_ = mixed(colour_, slats, shutter.covers(x, y, at_));
    }
  }

  const Surface& wall_;
  const Facade& facade_;
  const Appearance& look_;
  const TexturePoint& at_;
  Colour colour_;
};

}  // namespace

Colour facadeColour(const Surface& wall, const Facade& facade, const TexturePoint& at) {
  return Drawing(wall, facade, at).draw();
}

}  // namespace handmap
