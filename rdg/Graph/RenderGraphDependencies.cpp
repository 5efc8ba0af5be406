// Finds who depends on whom by the last writer of each subresource.
#include "RenderGraphDependencies.h"

#include <algorithm>
#include <array>

namespace Drydock
{

namespace
{

/** Last writer per pipeline; -1 none. */
using FWriters = std::array<int32_t, 2>;

void SortUnique(std::vector<int32_t>& Values)
{
	if (Values.size() < 2)
	{
		return;
	}
	std::sort(Values.begin(), Values.end());
	Values.erase(std::unique(Values.begin(), Values.end()), Values.end());
}

/** Calls Function with the index of each subresource of a box. */
template<typename TFunction>
void ForEachSubresource(const FRDGResourceDescription& Resource, const FRDGSubresources& Box, TFunction Function)
{
	for (int32_t Plane = Box.Plane; Plane < Box.Plane + Box.NumPlanes; ++Plane)
	{
		for (int32_t Slice = Box.Slice; Slice < Box.Slice + Box.NumSlices; ++Slice)
		{
			for (int32_t Mip = Box.FirstMip; Mip < Box.FirstMip + Box.NumMips; ++Mip)
			{
				Function(size_t(Mip + Resource.NumMips * (Slice + Resource.NumSlices * Plane)));
			}
		}
	}
}

} // namespace

FRDGDependencies FindDependencies(const FRDGGraphDescription& Graph)
{
	std::vector<size_t> First; // of a resource's subresources in Writers
	First.reserve(Graph.Resources.size() + 1);
	First.push_back(0);
	for (const FRDGResourceDescription& Resource : Graph.Resources)
	{
		First.push_back(First.back() + size_t(Resource.GetNumSubresources()));
	}
	std::vector<FWriters> Writers(First.back(), FWriters{-1, -1});

	FRDGDependencies Result;
	Result.Producers.resize(Graph.Passes.size());
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		std::vector<int32_t>& Producers = Result.Producers[size_t(Pass.Index)];
		Producers = Pass.DeclaredProducers;
		for (const FRDGUse& Use : Pass.Uses)
		{
			ForEachSubresource(Graph.Resources[size_t(Use.Resource)], Use,
				[&](size_t Index)
				{
					for (const int32_t Writer : Writers[First[size_t(Use.Resource)] + Index])
					{
						if (Writer >= 0)
						{
							Producers.push_back(Writer);
						}
					}
				});
		}
		// Only now: a pass that reads and writes one subresource does not depend on itself.
		for (const FRDGUse& Use : Pass.Uses)
		{
			if (Use.IsWrite())
			{
				ForEachSubresource(Graph.Resources[size_t(Use.Resource)], Use,
					[&](size_t Index) { Writers[First[size_t(Use.Resource)] + Index][Pass.bAsync] = Pass.Index; });
			}
		}
		SortUnique(Producers);
	}

	Result.LastWriters.resize(Graph.Resources.size());
	for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
	{
		std::vector<int32_t>& LastWriters = Result.LastWriters[Resource];
		for (size_t Index = First[Resource]; Index < First[Resource + 1]; ++Index)
		{
			std::copy_if(Writers[Index].begin(), Writers[Index].end(), std::back_inserter(LastWriters),
				[](int32_t Writer) { return Writer >= 0; });
		}
		SortUnique(LastWriters);
	}
	return Result;
}

} // namespace Drydock
