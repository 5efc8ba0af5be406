// Finds the state changes that a GPU would need barriers for.
#include "RenderGraphTransitions.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace Drydock
{

namespace
{

/** What a subresource is used as over a run of passes. */
struct FState
{
	ERHIAccess Access = ERHIAccess::Unknown;
	int32_t FirstPass = 0;
	int32_t LastPass = 0;
	bool bAsync = false;
	int32_t SkipBarrierView = -1;
};

bool IsUAV(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::UAVMask);
}

bool NeedsUAVBarrier(const FState& Before, const FState& After, bool bOverlapUAVs)
{
	if (!IsUAV(Before.Access) || !IsUAV(After.Access))
	{
		return false;
	}
	return !(bOverlapUAVs && Before.SkipBarrierView >= 0 && Before.SkipBarrierView == After.SkipBarrierView);
}

bool CanMerge(const FState& Before, const FState& After, bool bOverlapUAVs)
{
	const ERHIAccess DepthMask = ERHIAccess::DSVRead | ERHIAccess::DSVWrite;
	const bool bReadThenWrite =
		EnumHasAnyFlags(Before.Access, ERHIAccess::ReadOnlyExclusiveMask) && IsWritableAccess(After.Access);
	const bool bWriteThenRead =
		EnumHasAnyFlags(Before.Access, ERHIAccess::WriteOnlyExclusiveMask) && IsReadableAccess(After.Access);
	const bool bMixedUAV = IsUAV(Before.Access) != IsUAV(After.Access);
	const bool bMixedDepth = (EnumHasAllFlags(Before.Access, DepthMask) || EnumHasAllFlags(After.Access, DepthMask)) &&
							 Before.Access != After.Access;
	if (bReadThenWrite || bWriteThenRead || bMixedUAV || bMixedDepth || NeedsUAVBarrier(Before, After, bOverlapUAVs))
	{
		return false;
	}
	if (Before.Access == After.Access)
	{
		return Before.bAsync == After.bAsync ||
			   !EnumHasAnyFlags(Before.Access, ~ERHIAccess::ReadOnlyExclusiveComputeMask);
	}
	// Different states become one only where hardware knows combined states: those that read.
	const ERHIAccess Mergeable =
		Before.bAsync == After.bAsync ? ERHIAccess::ReadOnlyMask : ERHIAccess::ReadOnlyExclusiveComputeMask;
	return !EnumHasAnyFlags(Before.Access | After.Access, ~Mergeable);
}

/** All uses a pass makes of one subresource, as one state. */
ERHIAccess Combine(ERHIAccess A, ERHIAccess B)
{
	const ERHIAccess Union = A | B;
	return IsWritableAccess(Union) ? Union & ~ERHIAccess::ReadOnlyExclusiveMask : Union;
}

bool Covers(const FRDGSubresources& Box, int32_t Mip, int32_t Slice, int32_t Plane)
{
	return Mip >= Box.FirstMip && Mip < Box.FirstMip + Box.NumMips && Slice >= Box.Slice &&
		   Slice < Box.Slice + Box.NumSlices && Plane >= Box.Plane && Plane < Box.Plane + Box.NumPlanes;
}

class FTransitionFinder
{
public:
	FTransitionFinder(
		const FRDGGraphDescription& InGraph, const std::vector<bool>& bInCulled, const FRDGTransitionOptions& InOptions)
		: Graph(InGraph)
		, bCulled(bInCulled)
		, Options(InOptions)
	{
		UsesByResource.resize(Graph.Resources.size());
		for (const FRDGPassDescription& Pass : Graph.Passes)
		{
			for (const FRDGUse& Use : Pass.Uses)
			{
				if (!bCulled[size_t(Pass.Index)])
				{
					UsesByResource[size_t(Use.Resource)].push_back({&Pass, &Use});
				}
			}
		}
	}

	std::vector<FRDGTransition> Run()
	{
		for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
		{
			if (!Graph.Resources[Resource].bSkipTracking && !UsesByResource[Resource].empty())
			{
				AddResource(int32_t(Resource));
			}
		}
		std::stable_sort(Transitions.begin(), Transitions.end(),
			[](const FRDGTransition& A, const FRDGTransition& B)
			{ return std::tie(A.EndPass, A.Resource) < std::tie(B.EndPass, B.Resource); });
		return std::move(Transitions);
	}

private:
	struct FPassUse
	{
		const FRDGPassDescription* Pass;
		const FRDGUse* Use;
	};

	void AddResource(int32_t Resource)
	{
		const FRDGResourceDescription& Description = Graph.Resources[size_t(Resource)];
		std::vector<FRDGTransition> Found;
		for (int32_t Plane = 0; Plane < Description.NumPlanes; ++Plane)
		{
			for (int32_t Slice = 0; Slice < Description.NumSlices; ++Slice)
			{
				for (int32_t Mip = 0; Mip < Description.NumMips; ++Mip)
				{
					AddSubresource(Resource, Mip, Slice, Plane, Found);
				}
			}
		}
		JoinWhole(Description, Found);
		Transitions.insert(Transitions.end(), Found.begin(), Found.end());
	}

	void AddSubresource(int32_t Resource, int32_t Mip, int32_t Slice, int32_t Plane, std::vector<FRDGTransition>& Found)
	{
		const FRDGResourceDescription& Description = Graph.Resources[size_t(Resource)];
		std::vector<FState> States = CollectStates(Resource, Mip, Slice, Plane);
		if (States.empty())
		{
			return;
		}
		FState Initial;
		Initial.Access = Description.bExternal                  ? kDefaultAccessFinal
						 : Options.bTransient[size_t(Resource)] ? ERHIAccess::Discard
																: kDefaultAccessInitial;
		States.insert(States.begin(), Initial);
		if (Description.bExternal || Description.bExtracted)
		{
			FState Final;
			Final.Access =
				Description.AccessFinal == ERHIAccess::Unknown ? kDefaultAccessFinal : Description.AccessFinal;
			Final.FirstPass = Final.LastPass = Graph.GetEpilogue();
			States.push_back(Final);
		}
		for (size_t Index = 1; Index < States.size(); ++Index)
		{
			const FState& Before = States[Index - 1];
			const FState& After = States[Index];
			const bool bUAVBarrier = NeedsUAVBarrier(Before, After, Options.bOverlapUAVs);
			if (Before.Access == After.Access && Before.bAsync == After.bAsync && !bUAVBarrier)
			{
				continue;
			}
			FRDGTransition Transition;
			static_cast<FRDGSubresources&>(Transition) = {Mip, 1, Slice, 1, Plane, 1};
			Transition.Resource = Resource;
			Transition.Before = Before.Access;
			Transition.After = After.Access;
			Transition.BeginPass = Before.LastPass;
			Transition.EndPass = After.FirstPass;
			Transition.bUAVBarrier = bUAVBarrier;
			Found.push_back(Transition);
		}
	}

	/** States over time, merged where they can be one. */
	std::vector<FState> CollectStates(int32_t Resource, int32_t Mip, int32_t Slice, int32_t Plane) const
	{
		std::vector<FState> States;
		for (const FPassUse& PassUse : UsesByResource[size_t(Resource)])
		{
			if (!Covers(*PassUse.Use, Mip, Slice, Plane))
			{
				continue;
			}
			FState State;
			State.Access = PassUse.Use->Access;
			State.FirstPass = State.LastPass = PassUse.Pass->Index;
			State.bAsync = PassUse.Pass->bAsync;
			State.SkipBarrierView = PassUse.Use->SkipBarrierView;
			if (!States.empty() && States.back().LastPass == State.FirstPass)
			{
				// Several parameters of one pass: one state, whose barriers are between passes only.
				States.back().Access = Combine(States.back().Access, State.Access);
				States.back().SkipBarrierView =
					States.back().SkipBarrierView == State.SkipBarrierView ? State.SkipBarrierView : -1;
				continue;
			}
			States.push_back(State);
		}
		std::vector<FState> Merged;
		for (const FState& State : States)
		{
			if (!Merged.empty() && CanMerge(Merged.back(), State, Options.bOverlapUAVs))
			{
				Merged.back().Access |= State.Access;
				Merged.back().LastPass = State.LastPass;
			}
			else
			{
				Merged.push_back(State);
			}
		}
		return Merged;
	}

	/** A transition that every subresource makes alike is one of the whole resource. */
	static void JoinWhole(const FRDGResourceDescription& Description, std::vector<FRDGTransition>& Found)
	{
		const int32_t NumSubresources = Description.GetNumSubresources();
		if (NumSubresources == 1)
		{
			return;
		}
		const auto GetKey = [](const FRDGTransition& Transition)
		{
			return std::tuple(
				Transition.BeginPass, Transition.EndPass, Transition.Before, Transition.After, Transition.bUAVBarrier);
		};
		std::map<decltype(GetKey(Found[0])), int32_t> NumAlike;
		for (const FRDGTransition& Transition : Found)
		{
			++NumAlike[GetKey(Transition)];
		}
		std::vector<FRDGTransition> Joined;
		for (const FRDGTransition& Transition : Found)
		{
			int32_t& Num = NumAlike[GetKey(Transition)];
			if (Num == NumSubresources)
			{
				static_cast<FRDGSubresources&>(Joined.emplace_back(Transition)) = Description.GetWhole();
				Num = 0; // the others are in it
			}
			else if (Num > 0)
			{
				Joined.push_back(Transition);
			}
		}
		Found = std::move(Joined);
	}

	const FRDGGraphDescription& Graph;
	const std::vector<bool>& bCulled;
	const FRDGTransitionOptions& Options;
	std::vector<std::vector<FPassUse>> UsesByResource;
	std::vector<FRDGTransition> Transitions;
};

} // namespace

std::vector<FRDGTransition> FindTransitions(
	const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled, const FRDGTransitionOptions& Options)
{
	return FTransitionFinder(Graph, bCulled, Options).Run();
}

} // namespace Drydock
