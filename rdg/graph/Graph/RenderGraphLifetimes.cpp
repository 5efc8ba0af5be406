// Finds the first and the last pass of each resource.
#include "RenderGraphLifetimes.h"

#include <algorithm>

namespace Drydock
{

namespace
{

void Widen(FRDGLifetime& Lifetime, int32_t First, int32_t Last)
{
	Lifetime.First = Lifetime.First < 0 ? First : std::min(Lifetime.First, First);
	Lifetime.Last = std::max(Lifetime.Last, Last);
}

} // namespace

std::vector<FRDGLifetime> FindLifetimes(const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled,
	const std::vector<FRDGAsyncWindow>& AsyncWindows, bool bExtend)
{
	std::vector<FRDGLifetime> Lifetimes(Graph.Resources.size());
	std::vector<int32_t> LastUsers(Graph.Resources.size(), -1); // so that a pass of several uses counts once
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		const FRDGAsyncWindow& Window = AsyncWindows[size_t(Pass.Index)];
		for (const FRDGUse& Use : Pass.Uses)
		{
			if (LastUsers[size_t(Use.Resource)] == Pass.Index)
			{
				continue;
			}
			LastUsers[size_t(Use.Resource)] = Pass.Index;
			FRDGLifetime& Lifetime = Lifetimes[size_t(Use.Resource)];
			if (bCulled[size_t(Pass.Index)])
			{
				Lifetime.CulledUsers.push_back(Pass.Index);
				continue;
			}
			Widen(Lifetime, Pass.Index, Pass.Index);
			if (Window.Fork >= 0)
			{
				Widen(Lifetime, Window.Fork, Window.Join);
			}
			++Lifetime.NumUses;
		}
	}

	for (size_t Resource = 0; Resource < Lifetimes.size(); ++Resource)
	{
		FRDGLifetime& Lifetime = Lifetimes[Resource];
		if (Lifetime.First < 0)
		{
			continue;
		}
		Lifetime.CulledUsers.clear();
		if (bExtend)
		{
			Widen(Lifetime, 0, Graph.GetEpilogue());
		}
		else if (Graph.Resources[Resource].bExtracted)
		{
			Widen(Lifetime, Lifetime.First, Graph.GetEpilogue());
		}
	}
	return Lifetimes;
}

} // namespace Drydock
