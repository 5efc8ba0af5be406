// Finds the raster passes that a GPU would run as one render pass, and the reasons against others.
#include "RenderGraphMerge.h"

#include <algorithm>

namespace Drydock
{

namespace
{

bool WritesOnlyTargets(const FRDGPassDescription& Pass)
{
	constexpr ERHIAccess Others = ERHIAccess::UAVMask | ERHIAccess::CopyDest | ERHIAccess::BVHWrite;
	return std::ranges::none_of(Pass.Uses, [](const FRDGUse& Use) { return EnumHasAnyFlags(Use.Access, Others); });
}

/** Empty when the two may be one render pass. */
const char* FindObstacle(const FRDGPassDescription& Before, const FRDGPassDescription& After)
{
	const ERDGPassFlags Refusing = ERDGPassFlags::SkipRenderPass | ERDGPassFlags::NeverMerge;
	if (EnumHasAnyFlags(Before.Flags | After.Flags, Refusing))
	{
		return "a pass has SkipRenderPass or NeverMerge";
	}
	if (!WritesOnlyTargets(Before) || !WritesOnlyTargets(After))
	{
		return "a pass writes through more than its render targets";
	}
	const FRDGTargets& A = Before.Targets;
	const FRDGTargets& B = After.Targets;
	const auto IsSameTarget = [](const FRDGTarget& X, const FRDGTarget& Y)
	{
		return X.Resource == Y.Resource && X.ResolveResource == Y.ResolveResource && X.Mip == Y.Mip &&
			   X.Slice == Y.Slice;
	};
	if (!std::ranges::equal(A.Colors, B.Colors, IsSameTarget))
	{
		return "different render targets";
	}
	if (A.DepthStencil != B.DepthStencil || A.DepthStencilAccess != B.DepthStencilAccess)
	{
		return "different depth-stencil targets";
	}
	if (A.ResolveRect != B.ResolveRect || A.ShadingRate != B.ShadingRate)
	{
		return "different resolve rectangle or shading-rate texture";
	}
	if (A.NumOcclusionQueries != B.NumOcclusionQueries && A.NumOcclusionQueries && B.NumOcclusionQueries)
	{
		return "different numbers of occlusion queries";
	}
	const auto Clears = [](const FRDGTarget& Target)
	{
		return Target.Load == ERenderTargetLoadAction::EClear;
	};
	const bool bDepthClears = B.DepthStencil >= 0 && (B.DepthLoad == ERenderTargetLoadAction::EClear ||
														 B.StencilLoad == ERenderTargetLoadAction::EClear);
	return bDepthClears || std::ranges::any_of(B.Colors, Clears) ? "the pass clears its targets" : "";
}

} // namespace

std::vector<FRDGRenderPass> MergeRenderPasses(
	const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled, bool bEnabled)
{
	std::vector<FRDGRenderPass> Result(Graph.Passes.size());
	int32_t Before = -1;                          // the raster pass that the next one could join
	const FRDGPassDescription* Between = nullptr; // ran since the raster pass before
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		const size_t Index = size_t(Pass.Index);
		if (bCulled[Index] || Pass.bIsSentinel || Pass.bAsync || !Pass.bHasParameters)
		{
			continue; // none of these interrupts a render pass
		}
		if (!EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::Raster))
		{
			Between = Before >= 0 ? &Pass : Between;
			Before = -1;
			continue;
		}
		FRDGRenderPass& RenderPass = Result[Index];
		if (Before < 0)
		{
			RenderPass.Reason = Between ? Between->Name + " runs in between" : "first raster pass";
		}
		else
		{
			RenderPass.Reason = bEnabled ? FindObstacle(Graph.Passes[size_t(Before)], Pass) : "merging is off";
		}
		RenderPass.Begin = RenderPass.Reason.empty() ? Result[size_t(Before)].Begin : Pass.Index;
		Result[size_t(RenderPass.Begin)].End = Pass.Index;
		Before = Pass.Index;
	}
	for (FRDGRenderPass& RenderPass : Result)
	{
		RenderPass.End = RenderPass.Begin < 0 ? -1 : Result[size_t(RenderPass.Begin)].End;
	}
	return Result;
}

} // namespace Drydock
