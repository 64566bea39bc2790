// The files that are bags, one reader each.
#pragma once

#include "core/bags/bag.h"

namespace handmap {

std::unique_ptr<Bag> openRos1Bag(const std::filesystem::path& path, const std::stop_token& stop);
std::unique_ptr<Bag> openMcap(const std::filesystem::path& path, const std::stop_token& stop);
std::unique_ptr<Bag> openSqliteBag(const std::filesystem::path& path, const std::stop_token& stop);
/// Several files as one, in their order.
std::unique_ptr<Bag> joinedBags(const std::filesystem::path& folder,
                                std::vector<std::unique_ptr<Bag>> parts);

}  // namespace handmap
