// Small functions over ranges that several rooms share.
#pragma once

#include <algorithm>
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

/** The first item that has the value, or whose member has it; null: none has. */
template<typename TRange, typename T, typename TMember = std::identity>
auto* FindItem(TRange& Items, const T& Value, TMember Member = {})
{
	const auto Found =
		std::ranges::find_if(Items, [&](const auto& Item) { return std::invoke(Member, Item) == Value; });
	return Found == std::ranges::end(Items) ? nullptr : &*Found;
}

/** Whether an item has the value, or its member has it. */
template<typename TRange, typename T, typename TMember = std::identity>
bool Contains(const TRange& Items, const T& Value, TMember Member = {})
{
	return FindItem(Items, Value, Member) != nullptr;
}

/** Appends a value that is not in the list yet. */
template<typename T>
void AddUnique(std::vector<T>& Items, const T& Value)
{
	if (!Contains(Items, Value))
	{
		Items.push_back(Value);
	}
}

} // namespace Drydock
