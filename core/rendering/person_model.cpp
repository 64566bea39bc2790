#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"
#include "core/rendering/tube.h"

namespace handmap {

namespace {

constexpr std::uint32_t kPerson = 25;
constexpr int kSides = 8;

constexpr Reflectance kJacket[] = {
    {0.04F, 0.04F, 0.045F}, {0.05F, 0.08F, 0.20F}, {0.40F, 0.05F, 0.05F}, {0.60F, 0.59F, 0.56F},
    {0.16F, 0.17F, 0.12F},  {0.28F, 0.22F, 0.14F}, {0.20F, 0.21F, 0.23F}, {0.10F, 0.30F, 0.34F}};
constexpr Reflectance kTrousers[] = {
    {0.04F, 0.06F, 0.12F}, {0.03F, 0.03F, 0.03F}, {0.18F, 0.18F, 0.18F}, {0.30F, 0.25F, 0.17F}};
constexpr Reflectance kSkin[] = {
    {0.55F, 0.36F, 0.27F}, {0.45F, 0.28F, 0.20F}, {0.25F, 0.14F, 0.09F}};
constexpr Reflectance kHair[] = {
    {0.02F, 0.015F, 0.01F}, {0.09F, 0.05F, 0.03F}, {0.35F, 0.25F, 0.13F}, {0.40F, 0.39F, 0.37F}};

template <std::size_t Count>
Colour oneOf(const Reflectance (&palette)[Count], RandomStream& random) {
  return static_cast<float>(random.uniform(0.8, 1.2)) * colourOf(palette[random.index(Count)]);
}

class PersonModel {
 public:
  PersonModel(const Thing& person, std::uint64_t seed, std::uint32_t number, Model& model)
      : model_(model),
        frame_{person.footprint.centre.x(), person.footprint.centre.y(), person.footprint.heading},
        scale_(person.height / 1.75),
        random_(seed, number, 0, kPerson) {
    look_.label = Label::Pedestrian;
    look_.seed = hashOf(static_cast<std::uint32_t>(seed), number, kPerson);
  }

  /// Measures of someone 1.75 m tall.
  void add() {
    const Colour jacket = oneOf(kJacket, random_);
    const Colour trousers = oneOf(kTrousers, random_);
    const Colour skin = oneOf(kSkin, random_);
    const Colour hair = oneOf(kHair, random_);
    const Colour shoes(0.04F, 0.035F, 0.03F);
    const double stride = random_.uniform(-0.12, 0.12);
    const double swing = random_.uniform(-0.1, 0.1);
    const double hem = random_.uniform() < 0.3 ? 0.55 : 0.84;  // a coat or a jacket
    for (const double side : {1.0, -1.0}) {
      const double step = side * stride;
      const double y = side * 0.1;
      tube(shoes, {{step + 0.04, y, 0.0, 0.14, 0.05}, {step, y, 0.09, 0.06, 0.05}});
      tube(trousers, {{step, y, 0.06, 0.06, 0.06},
                      {0.6 * step, y, 0.48, 0.075, 0.07},
                      {0.0, y, 0.88, 0.1, 0.095}});
      const double arm = -side * swing;
      tube(skin, {{arm, side * 0.27, 0.72, 0.045, 0.025}, {arm, side * 0.27, 0.84, 0.035, 0.03}});
      tube(jacket, {{arm, side * 0.27, 0.82, 0.045, 0.045},
                    {0.3 * arm, side * 0.27, 1.12, 0.05, 0.05},
                    {0.0, side * 0.2, 1.44, 0.07, 0.06}});
    }
    tube(jacket, {{0.0, 0.0, hem, 0.14, 0.2},
                  {0.0, 0.0, 1.08, 0.12, 0.17},
                  {0.0, 0.0, 1.36, 0.12, 0.21},
                  {0.0, 0.0, 1.47, 0.08, 0.12}});
    tube(skin, {{0.0, 0.0, 1.44, 0.055, 0.055},
                {0.02, 0.0, 1.54, 0.08, 0.06},
                {0.015, 0.0, 1.64, 0.095, 0.075}});
    tube(hair, {{-0.02, 0.0, 1.58, 0.085, 0.08},
                {-0.005, 0.0, 1.67, 0.1, 0.082},
                {-0.01, 0.0, 1.75, 0.05, 0.04}});
  }

 private:
  void tube(const Colour& colour, std::vector<Ring> rings) {
    for (Ring& ring : rings) {
      for (double* measure : {&ring.x, &ring.y, &ring.z, &ring.along, &ring.across}) {
        *measure *= scale_;
      }
    }
    look_.material = Material::Cloth;
    look_.colour = colour;
    addTube(frame_, rings, kSides, look_, model_);
  }

  Model& model_;
  Pose2 frame_;
  double scale_;
  RandomStream random_;
  Surface look_;
};

}  // namespace

void addPerson(const Thing& person, std::uint64_t seed, std::uint32_t number, Model& model) {
  PersonModel(person, seed, number, model).add();
}

}  // namespace handmap
