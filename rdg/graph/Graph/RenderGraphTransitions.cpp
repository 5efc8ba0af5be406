// Finds the state changes that a GPU would need barriers for.
#include "RenderGraphTransitions.h"

#include <map>
#include <numeric>
#include <tuple>

namespace Drydock
{

namespace
{

/** The access to a subresource over a run of passes. */
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
		FirstUse.resize(Graph.Resources.size() + 1);
		ForEachUse([this](const FRDGPassDescription&, const FRDGUse& Use) { ++FirstUse[size_t(Use.Resource) + 1]; });
		std::partial_sum(FirstUse.begin(), FirstUse.end(), FirstUse.begin());
		std::vector<size_t> Next = FirstUse;
		Uses.resize(FirstUse.back());
		ForEachUse(
			[&](const FRDGPassDescription& Pass, const FRDGUse& Use) {
				Uses[Next[size_t(Use.Resource)]++] = {&Pass, &Use};
			});
	}

	std::vector<FRDGTransition> Run()
	{
		for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
		{
			if (!Graph.Resources[Resource].bSkipTracking && FirstUse[Resource] < FirstUse[Resource + 1])
			{
				AddResource(int32_t(Resource));
			}
		}
		return SortByEnd();
	}

private:
	struct FPassUse
	{
		const FRDGPassDescription* Pass;
		const FRDGUse* Use;
	};

	template<typename TFunction>
	void ForEachUse(TFunction Function) const
	{
		for (const FRDGPassDescription& Pass : Graph.Passes)
		{
			for (const FRDGUse& Use : Pass.Uses)
			{
				if (!bCulled[size_t(Pass.Index)])
				{
					Function(Pass, Use);
				}
			}
		}
	}

	/** They were found by resource, and stay so among those of one pass. */
	std::vector<FRDGTransition> SortByEnd() const
	{
		std::vector<size_t> Next(Graph.Passes.size() + 1);
		for (const FRDGTransition& Transition : Transitions)
		{
			++Next[size_t(Transition.EndPass) + 1];
		}
		std::partial_sum(Next.begin(), Next.end(), Next.begin());
		std::vector<FRDGTransition> Sorted(Transitions.size());
		for (const FRDGTransition& Transition : Transitions)
		{
			Sorted[Next[size_t(Transition.EndPass)]++] = Transition;
		}
		return Sorted;
	}

	void AddResource(int32_t Resource)
	{
		const FRDGResourceDescription& Description = Graph.Resources[size_t(Resource)];
		OfResource.clear();
		for (int32_t Plane = 0; Plane < Description.NumPlanes; ++Plane)
		{
			for (int32_t Slice = 0; Slice < Description.NumSlices; ++Slice)
			{
				for (int32_t Mip = 0; Mip < Description.NumMips; ++Mip)
				{
					AddSubresource(Resource, Mip, Slice, Plane);
				}
			}
		}
		JoinWhole(Description, OfResource);
		Transitions.insert(Transitions.end(), OfResource.begin(), OfResource.end());
	}

	void AddSubresource(int32_t Resource, int32_t Mip, int32_t Slice, int32_t Plane)
	{
		const FRDGResourceDescription& Description = Graph.Resources[size_t(Resource)];
		FState Initial;
		Initial.Access = Description.bExternal                  ? kDefaultAccessFinal
						 : Options.bTransient[size_t(Resource)] ? ERHIAccess::Discard
																: kDefaultAccessInitial;
		States.assign(1, Initial);
		CollectStates(Resource, Mip, Slice, Plane);
		if (States.size() == 1)
		{
			return;
		}
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
			OfResource.push_back(Transition);
		}
	}

	/** Appends the states over time, merged where they can be one. */
	void CollectStates(int32_t Resource, int32_t Mip, int32_t Slice, int32_t Plane)
	{
		OfPasses.clear();
		for (size_t Index = FirstUse[size_t(Resource)]; Index < FirstUse[size_t(Resource) + 1]; ++Index)
		{
			const FPassUse& PassUse = Uses[Index];
			if (!Covers(*PassUse.Use, Mip, Slice, Plane))
			{
				continue;
			}
			FState State;
			State.Access = PassUse.Use->Access;
			State.FirstPass = State.LastPass = PassUse.Pass->Index;
			State.bAsync = PassUse.Pass->bAsync;
			State.SkipBarrierView = PassUse.Use->SkipBarrierView;
			if (!OfPasses.empty() && OfPasses.back().LastPass == State.FirstPass)
			{
				// Several parameters of one pass: one state, whose barriers are between passes only.
				FState& Known = OfPasses.back();
				Known.Access = Combine(Known.Access, State.Access);
				Known.SkipBarrierView = Known.SkipBarrierView == State.SkipBarrierView ? State.SkipBarrierView : -1;
				continue;
			}
			OfPasses.push_back(State);
		}
		const size_t NumBefore = States.size();
		for (const FState& State : OfPasses)
		{
			if (States.size() > NumBefore && CanMerge(States.back(), State, Options.bOverlapUAVs))
			{
				States.back().Access |= State.Access;
				States.back().LastPass = State.LastPass;
			}
			else
			{
				States.push_back(State);
			}
		}
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
	std::vector<FPassUse> Uses;   // of surviving passes, by resource
	std::vector<size_t> FirstUse; // by resource, and the end
	std::vector<FRDGTransition> Transitions;

	// Scratch for one resource or subresource at a time.
	std::vector<FRDGTransition> OfResource;
	std::vector<FState> OfPasses;
	std::vector<FState> States;
};

} // namespace

std::vector<FRDGTransition> FindTransitions(
	const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled, const FRDGTransitionOptions& Options)
{
	return FTransitionFinder(Graph, bCulled, Options).Run();
}

} // namespace Drydock
