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
	std::vector<std::vector<FWriters>> Writers;
	for (const FRDGResourceDescription& Resource : Graph.Resources)
	{
		Writers.emplace_back(size_t(Resource.GetNumSubresources()), FWriters{-1, -1});
	}

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
					for (const int32_t Writer : Writers[size_t(Use.Resource)][Index])
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
					[&](size_t Index) { Writers[size_t(Use.Resource)][Index][Pass.bAsync] = Pass.Index; });
			}
		}
		SortUnique(Producers);
	}

	for (const std::vector<FWriters>& OfResource : Writers)
	{
		std::vector<int32_t>& LastWriters = Result.LastWriters.emplace_back();
		for (const FWriters& OfSubresource : OfResource)
		{
			std::copy_if(OfSubresource.begin(), OfSubresource.end(), std::back_inserter(LastWriters),
				[](int32_t Writer) { return Writer >= 0; });
		}
		SortUnique(LastWriters);
	}
	return Result;
}

} // namespace Drydock
