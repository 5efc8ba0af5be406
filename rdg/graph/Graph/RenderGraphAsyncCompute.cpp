// Finds the windows in which async-compute passes may run.
#include "RenderGraphAsyncCompute.h"

#include <algorithm>

namespace Drydock
{

std::vector<FRDGAsyncWindow> FindAsyncWindows(
	const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies, const std::vector<bool>& bCulled)
{
	const auto IsAsync = [&](int32_t Pass)
	{
		return Graph.Passes[size_t(Pass)].bAsync && !bCulled[size_t(Pass)];
	};
	const int32_t NumPasses = int32_t(Graph.Passes.size());
	std::vector<FRDGAsyncWindow> Windows(Graph.Passes.size());
	std::vector<int32_t> FirstGraphicsConsumer(Graph.Passes.size(), Graph.GetEpilogue());

	int32_t PreviousFork = 0;
	for (int32_t Pass = 0; Pass < NumPasses; ++Pass)
	{
		if (bCulled[size_t(Pass)])
		{
			continue;
		}
		for (const int32_t Producer : Dependencies.Producers[size_t(Pass)])
		{
			if (IsAsync(Pass) && !Graph.Passes[size_t(Producer)].bAsync)
			{
				PreviousFork = std::max(PreviousFork, Producer);
			}
			else if (!IsAsync(Pass))
			{
				FirstGraphicsConsumer[size_t(Producer)] = std::min(FirstGraphicsConsumer[size_t(Producer)], Pass);
			}
		}
		if (IsAsync(Pass))
		{
			Windows[size_t(Pass)].Fork = PreviousFork;
		}
	}

	int32_t LaterJoin = Graph.GetEpilogue();
	for (int32_t Pass = NumPasses - 1; Pass >= 0; --Pass)
	{
		if (IsAsync(Pass))
		{
			LaterJoin = std::min(LaterJoin, FirstGraphicsConsumer[size_t(Pass)]);
			Windows[size_t(Pass)].Join = LaterJoin;
		}
	}
	return Windows;
}

} // namespace Drydock
