// How often windows are judged rightly.
#pragma once

namespace handmap {

struct Confusion {
  int building_as_building = 0;
  int building_as_other = 0;
  int other_as_building = 0;
  int other_as_other = 0;

  void add(bool is_building, bool judged_building) {
    (is_building ? (judged_building ? building_as_building : building_as_other)
                 : (judged_building ? other_as_building : other_as_other)) += 1;
  }
  int buildings() const { return building_as_building + building_as_other; }
  int others() const { return other_as_building + other_as_other; }
  /// Mean of the shares of buildings and of others that are judged rightly. All shares are 0 where
  /// there is nothing to take a share of.
  double balancedAccuracy() const {
    return 0.5 * (recall() + share(other_as_other, other_as_building));
  }
  double precision() const { return share(building_as_building, other_as_building); }
  double recall() const { return share(building_as_building, building_as_other); }
  double f1() const {
    return share(2 * building_as_building, other_as_building + building_as_other);
  }

 private:
  static double share(int good, int bad) {
    return good + bad == 0 ? 0.0 : static_cast<double>(good) / (good + bad);
  }
};

}  // namespace handmap
