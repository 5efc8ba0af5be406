// Decides which passes are left out, and notes what became of their readers.
#include "RenderGraphCull.h"

namespace Drydock
{

namespace
{

bool IsRoot(const FRDGPassDescription& Pass)
{
	return Pass.bIsSentinel || !Pass.bHasParameters || Pass.bHasExternalOutputs ||
		   EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::NeverCull);
}

std::vector<int32_t> FindRoots(const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies)
{
	std::vector<int32_t> Roots;
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		if (IsRoot(Pass))
		{
			Roots.push_back(Pass.Index);
		}
	}
	for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
	{
		if (Graph.Resources[Resource].bExternal || Graph.Resources[Resource].bExtracted)
		{
			const std::vector<int32_t> Writers = Dependencies.GetLastWriters(Resource);
			Roots.insert(Roots.end(), Writers.begin(), Writers.end());
		}
	}
	return Roots;
}

/** By pass. A culled pass's consumers are all culled, else it would have survived; they come after it. */
std::vector<FRDGCulledChain> FindChains(const FRDGDependencies& Dependencies, const std::vector<bool>& bCulled)
{
	std::vector<FRDGCulledChain> Chains(Dependencies.Producers.size());
	for (int32_t Pass = int32_t(Chains.size()) - 1; Pass >= 0; --Pass)
	{
		FRDGCulledChain& Chain = Chains[size_t(Pass)];
		if (!bCulled[size_t(Pass)])
		{
			Chain = FRDGCulledChain();
			continue;
		}
		Chain.End = Chain.Next < 0 ? Pass : Chains[size_t(Chain.Next)].End;
		Chain.Length = Chain.Next < 0 ? 0 : Chains[size_t(Chain.Next)].Length + 1;
		for (const int32_t Producer : Dependencies.Producers[size_t(Pass)])
		{
			Chains[size_t(Producer)].Next = Pass;
		}
	}
	return Chains;
}

} // namespace

FRDGCullResult CullPasses(const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies, bool bEnabled)
{
	FRDGCullResult Result;
	Result.bCulled.assign(Graph.Passes.size(), bEnabled);
	Result.Chains.resize(Graph.Passes.size());
	if (!bEnabled)
	{
		return Result;
	}

	std::vector<int32_t> Stack = FindRoots(Graph, Dependencies);
	while (!Stack.empty())
	{
		const size_t Pass = size_t(Stack.back());
		Stack.pop_back();
		if (Result.bCulled[Pass])
		{
			Result.bCulled[Pass] = false;
			const std::vector<int32_t>& Producers = Dependencies.Producers[Pass];
			Stack.insert(Stack.end(), Producers.begin(), Producers.end());
		}
	}

	Result.Chains = FindChains(Dependencies, Result.bCulled);
	return Result;
}

} // namespace Drydock
