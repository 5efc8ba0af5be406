// Finds who depends on whom by the last writer of each subresource.
#include "RenderGraphDependencies.h"

#include <algorithm>
#include <iterator>

namespace Drydock
{

namespace
{

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
	FRDGDependencies Result;
	std::vector<size_t>& First = Result.FirstSubresource;
	First.reserve(Graph.Resources.size() + 1);
	First.push_back(0);
	for (const FRDGResourceDescription& Resource : Graph.Resources)
	{
		First.push_back(First.back() + size_t(Resource.GetNumSubresources()));
	}
	std::vector<FRDGDependencies::FWriters>& Writers = Result.Writers;
	Writers.assign(First.back(), FRDGDependencies::FWriters{-1, -1});

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
	return Result;
}

std::vector<int32_t> FRDGDependencies::GetLastWriters(size_t Resource) const
{
	std::vector<int32_t> LastWriters;
	for (size_t Index = FirstSubresource[Resource]; Index < FirstSubresource[Resource + 1]; ++Index)
	{
		std::copy_if(Writers[Index].begin(), Writers[Index].end(), std::back_inserter(LastWriters),
			[](int32_t Writer) { return Writer >= 0; });
	}
	SortUnique(LastWriters);
	return LastWriters;
}

} // namespace Drydock
