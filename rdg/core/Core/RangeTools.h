// A small function over ranges that several rooms share.
#pragma once

#include <functional>
#include <vector>

namespace Drydock
{

/** Lists the values that a function, or a member, gives for the items. */
template<typename T, typename TRange, typename TFunction>
std::vector<T> ToVector(const TRange& Items, TFunction Function)
{
	std::vector<T> Result;
	for (const auto& Item : Items)
	{
		Result.push_back(std::invoke(Function, Item));
	}
	return Result;
}

} // namespace Drydock
