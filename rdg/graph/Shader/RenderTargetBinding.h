// Binds a raster pass's render targets: the member that RENDER_TARGET_BINDING_SLOTS() adds to a parameter struct.
// Source: engine ShaderParameterMacros.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"
#include "RenderGraphFwd.h"

/** Part of the target to resolve; -1: all of it. */
struct FResolveRect
{
	int32 X1 = -1;
	int32 Y1 = -1;
	int32 X2 = -1;
	int32 Y2 = -1;

	bool IsValid() const { return X1 >= 0 && Y1 >= 0 && X2 > X1 && Y2 > Y1; }
	bool operator==(const FResolveRect&) const = default;
};

/** One colour target: a mip and slice of a texture and what happens to its contents at the start. */
class FRenderTargetBinding
{
public:
	FRenderTargetBinding() = default;

	/** ArraySlice -1: all slices. */
	FRenderTargetBinding(
		FRDGTexture* InTexture, ERenderTargetLoadAction InLoadAction, uint8 InMipIndex = 0, int16 InArraySlice = -1)
		: Texture(InTexture)
		, LoadAction(InLoadAction)
		, MipIndex(InMipIndex)
		, ArraySlice(InArraySlice)
	{
	}

	/** With a multisampled texture's resolve target. */
	FRenderTargetBinding(FRDGTexture* InTexture, FRDGTexture* InResolveTexture, ERenderTargetLoadAction InLoadAction,
		uint8 InMipIndex = 0, int16 InArraySlice = -1)
		: Texture(InTexture)
		, ResolveTexture(InResolveTexture)
		, LoadAction(InLoadAction)
		, MipIndex(InMipIndex)
		, ArraySlice(InArraySlice)
	{
	}

	FRDGTexture* GetTexture() const { return Texture; }
	FRDGTexture* GetResolveTexture() const { return ResolveTexture; }
	ERenderTargetLoadAction GetLoadAction() const { return LoadAction; }
	uint8 GetMipIndex() const { return MipIndex; }
	int16 GetArraySlice() const { return ArraySlice; }
	bool IsValid() const { return Texture != nullptr; }

	void SetTexture(FRDGTexture* InTexture) { Texture = InTexture; }
	void SetLoadAction(ERenderTargetLoadAction InLoadAction) { LoadAction = InLoadAction; }
	void SetMipIndex(uint8 InMipIndex) { MipIndex = InMipIndex; }
	void SetArraySlice(int16 InArraySlice) { ArraySlice = InArraySlice; }

	bool operator==(const FRenderTargetBinding&) const = default;

private:
	FRDGTexture* Texture = nullptr;
	FRDGTexture* ResolveTexture = nullptr;
	ERenderTargetLoadAction LoadAction = ERenderTargetLoadAction::ENoAction;
	uint8 MipIndex = 0;
	int16 ArraySlice = -1;
};

/** The depth-stencil target. */
class FDepthStencilBinding
{
public:
	FDepthStencilBinding() = default;

	FDepthStencilBinding(FRDGTexture* InTexture, ERenderTargetLoadAction InDepthLoadAction,
		ERenderTargetLoadAction InStencilLoadAction, FExclusiveDepthStencil InDepthStencilAccess)
		: Texture(InTexture)
		, DepthLoadAction(InDepthLoadAction)
		, StencilLoadAction(InStencilLoadAction)
		, DepthStencilAccess(InDepthStencilAccess)
	{
	}

	FDepthStencilBinding(
		FRDGTexture* InTexture, ERenderTargetLoadAction InDepthLoadAction, FExclusiveDepthStencil InDepthStencilAccess)
		: Texture(InTexture)
		, DepthLoadAction(InDepthLoadAction)
		, DepthStencilAccess(InDepthStencilAccess)
	{
	}

	FRDGTexture* GetTexture() const { return Texture; }
	ERenderTargetLoadAction GetDepthLoadAction() const { return DepthLoadAction; }
	ERenderTargetLoadAction GetStencilLoadAction() const { return StencilLoadAction; }
	FExclusiveDepthStencil GetDepthStencilAccess() const { return DepthStencilAccess; }

	void SetTexture(FRDGTexture* InTexture) { Texture = InTexture; }
	void SetDepthLoadAction(ERenderTargetLoadAction InLoadAction) { DepthLoadAction = InLoadAction; }
	void SetStencilLoadAction(ERenderTargetLoadAction InLoadAction) { StencilLoadAction = InLoadAction; }
	void SetDepthStencilAccess(FExclusiveDepthStencil InAccess) { DepthStencilAccess = InAccess; }

private:
	FRDGTexture* Texture = nullptr;
	ERenderTargetLoadAction DepthLoadAction = ERenderTargetLoadAction::ENoAction;
	ERenderTargetLoadAction StencilLoadAction = ERenderTargetLoadAction::ENoAction;
	FExclusiveDepthStencil DepthStencilAccess = FExclusiveDepthStencil::DepthNop_StencilNop;
};

/** All targets of a raster pass. Slots must be filled from 0 on without gaps. */
class FRenderTargetBindingSlots
{
public:
	FRenderTargetBinding& operator[](uint32 Index)
	{
		check(Index < MaxSimultaneousRenderTargets);
		return Output[Index];
	}

	const FRenderTargetBinding& operator[](uint32 Index) const
	{
		check(Index < MaxSimultaneousRenderTargets);
		return Output[Index];
	}

	/** Calls Function(const FRenderTargetBinding&) for each slot up to the first empty one. */
	template<typename TFunction>
	void Enumerate(TFunction Function) const
	{
		for (const FRenderTargetBinding& Binding : Output)
		{
			if (!Binding.GetTexture())
			{
				break;
			}
			Function(Binding);
		}
	}

	/** Number of slots before the first empty one. */
	uint32 GetActiveCount() const
	{
		uint32 Count = 0;
		Enumerate([&Count](const FRenderTargetBinding&) { ++Count; });
		return Count;
	}

	FRenderTargetBinding Output[MaxSimultaneousRenderTargets];
	FDepthStencilBinding DepthStencil;
	FResolveRect ResolveRect;
	uint32 NumOcclusionQueries = 0;
	bool SubpassHint = false;
	uint8 MultiViewCount = 0;
	FRDGTexture* ShadingRateTexture = nullptr;
};
