// Keeps the first store to each place.
#include "StoreOverlap.h"

#include <map>

namespace Drydock
{

std::string ListThread(const std::array<int32_t, 3>& At)
{
	return "(" + std::to_string(At[0]) + ", " + std::to_string(At[1]) +
		   (At[2] ? ", " + std::to_string(At[2]) : std::string()) + ")";
}

std::vector<FStoreOverlap> FindOverlaps(const std::vector<FThreadStore>& Stores)
{
	std::map<std::pair<uint32_t, std::array<int32_t, 3>>, const FThreadStore*> First;
	std::vector<FStoreOverlap> Overlaps;
	for (const FThreadStore& Store : Stores)
	{
		const auto [Entry, bNew] = First.try_emplace({Store.Variable, Store.Texel}, &Store);
		const FThreadStore& Before = *Entry->second;
		if (!bNew && Before.Thread == Store.Thread)
		{
			Entry->second = &Store; // a thread's own stores have an order
		}
		else if (!bNew && Before.Value != Store.Value)
		{
			Overlaps.push_back({Before, Store});
		}
	}
	return Overlaps;
}

std::string DescribeOverlap(const FSpirvModule& Module, const FStoreOverlap& Overlap)
{
	const FSpirvVariable& Variable = Module.Variables.at(Overlap.Store.Variable);
	const bool bTexture = Module.GetType(Variable.Type).Kind == ESpirvType::Image &&
						  Module.GetType(Variable.Type).Dim != Spirv::DimBuffer;
	const std::string Place =
		bTexture ? " at " + ListThread(Overlap.Store.Texel) : "[" + std::to_string(Overlap.Store.Texel[0]) + "]";
	return "a store to " + Variable.Name + Place + ", where thread " + ListThread(Overlap.Before.Thread) +
		   " stores another value in line " + std::to_string(Overlap.Before.Step->I->Line);
}

} // namespace Drydock
