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

std::string ExplainUnused(const std::vector<std::string>& CulledUsers)
{
	if (CulledUsers.empty())
	{
		return "no pass uses it";
	}
	std::string Text = "all passes that use it are culled: ";
	for (const std::string& Name : CulledUsers)
	{
		Text += (&Name == &CulledUsers.front() ? "" : ", ") + Name;
	}
	return Text;
}

} // namespace

std::vector<FRDGLifetime> FindLifetimes(const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled,
	const std::vector<FRDGAsyncWindow>& AsyncWindows, bool bExtend)
{
	std::vector<FRDGLifetime> Lifetimes(Graph.Resources.size());
	std::vector<std::vector<std::string>> CulledUsers(Graph.Resources.size());
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		const FRDGAsyncWindow& Window = AsyncWindows[size_t(Pass.Index)];
		std::vector<int32_t> Touched;
		for (const FRDGUse& Use : Pass.Uses)
		{
			if (std::find(Touched.begin(), Touched.end(), Use.Resource) != Touched.end())
			{
				continue;
			}
			Touched.push_back(Use.Resource);
			if (bCulled[size_t(Pass.Index)])
			{
				CulledUsers[size_t(Use.Resource)].push_back(Pass.Name);
				continue;
			}
			FRDGLifetime& Lifetime = Lifetimes[size_t(Use.Resource)];
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
			Lifetime.Reason = ExplainUnused(CulledUsers[Resource]);
		}
		else if (bExtend)
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
