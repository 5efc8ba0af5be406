// Describes a render pass: the textures that are drawn to, and the treatment of their old contents. Also the other
// small argument structs of a command list. Source: engine RHIResources.h, RHIDefinitions.h.
#pragma once

#include "RHIDefinitions.h"
#include "RHITexture.h"

/** Load action in the high bits, store action in the low two. */
enum class ERenderTargetActions : uint8
{
	LoadOpMask = 2,

	DontLoad_DontStore =
		(uint8(ERenderTargetLoadAction::ENoAction) << LoadOpMask) | uint8(ERenderTargetStoreAction::ENoAction),
	DontLoad_Store =
		(uint8(ERenderTargetLoadAction::ENoAction) << LoadOpMask) | uint8(ERenderTargetStoreAction::EStore),
	Clear_Store = (uint8(ERenderTargetLoadAction::EClear) << LoadOpMask) | uint8(ERenderTargetStoreAction::EStore),
	Load_Store = (uint8(ERenderTargetLoadAction::ELoad) << LoadOpMask) | uint8(ERenderTargetStoreAction::EStore),
	Clear_DontStore =
		(uint8(ERenderTargetLoadAction::EClear) << LoadOpMask) | uint8(ERenderTargetStoreAction::ENoAction),
	Load_DontStore = (uint8(ERenderTargetLoadAction::ELoad) << LoadOpMask) | uint8(ERenderTargetStoreAction::ENoAction),
};

constexpr ERenderTargetActions MakeRenderTargetActions(ERenderTargetLoadAction Load, ERenderTargetStoreAction Store)
{
	return ERenderTargetActions((uint8(Load) << uint8(ERenderTargetActions::LoadOpMask)) | uint8(Store));
}

constexpr ERenderTargetLoadAction GetLoadAction(ERenderTargetActions Action)
{
	return ERenderTargetLoadAction(uint8(Action) >> uint8(ERenderTargetActions::LoadOpMask));
}

constexpr ERenderTargetStoreAction GetStoreAction(ERenderTargetActions Action)
{
	return ERenderTargetStoreAction(uint8(Action) & ((1 << uint8(ERenderTargetActions::LoadOpMask)) - 1));
}

/** Depth's actions in the high nibble, stencil's in the low one. */
enum class EDepthStencilTargetActions : uint8
{
	DepthMask = 4,

	DontLoad_DontStore = 0,
	LoadDepthStencil_StoreDepthStencil =
		(uint8(ERenderTargetActions::Load_Store) << DepthMask) | uint8(ERenderTargetActions::Load_Store),
	ClearDepthStencil_StoreDepthStencil =
		(uint8(ERenderTargetActions::Clear_Store) << DepthMask) | uint8(ERenderTargetActions::Clear_Store),
	LoadDepthStencil_DontStoreDepthStencil =
		(uint8(ERenderTargetActions::Load_DontStore) << DepthMask) | uint8(ERenderTargetActions::Load_DontStore),
	LoadDepthNotStencil_StoreDepthNotStencil =
		(uint8(ERenderTargetActions::Load_Store) << DepthMask) | uint8(ERenderTargetActions::DontLoad_DontStore),
};

constexpr EDepthStencilTargetActions MakeDepthStencilTargetActions(
	ERenderTargetActions Depth, ERenderTargetActions Stencil)
{
	return EDepthStencilTargetActions((uint8(Depth) << uint8(EDepthStencilTargetActions::DepthMask)) | uint8(Stencil));
}

constexpr ERenderTargetActions GetDepthActions(EDepthStencilTargetActions Action)
{
	return ERenderTargetActions(uint8(Action) >> uint8(EDepthStencilTargetActions::DepthMask));
}

constexpr ERenderTargetActions GetStencilActions(EDepthStencilTargetActions Action)
{
	return ERenderTargetActions(uint8(Action) & ((1 << uint8(EDepthStencilTargetActions::DepthMask)) - 1));
}

/** Argument of BeginRenderPass. */
struct FRHIRenderPassInfo
{
	struct FColorEntry
	{
		FRHITexture* RenderTarget = nullptr;
		FRHITexture* ResolveTarget = nullptr;
		int32 ArraySlice = -1; // -1: slice 0
		uint8 MipIndex = 0;
		ERenderTargetActions Action = ERenderTargetActions::DontLoad_DontStore;
	};

	struct FDepthStencilEntry
	{
		FRHITexture* DepthStencilTarget = nullptr;
		FRHITexture* ResolveTarget = nullptr;
		EDepthStencilTargetActions Action = EDepthStencilTargetActions::DontLoad_DontStore;
		FExclusiveDepthStencil ExclusiveDepthStencil;
	};

	FRHIRenderPassInfo() = default;

	FRHIRenderPassInfo(FRHITexture* ColorRT, ERenderTargetActions ColorAction)
		: FRHIRenderPassInfo(1, &ColorRT, ColorAction)
	{
	}

	FRHIRenderPassInfo(FRHITexture* ColorRT, ERenderTargetActions ColorAction, FRHITexture* ResolveRT,
		uint8 InMipIndex = 0, int32 InArraySlice = -1)
	{
		ColorRenderTargets[0] = {ColorRT, ResolveRT, InArraySlice, InMipIndex, ColorAction};
	}

	FRHIRenderPassInfo(int32 NumColorRTs, FRHITexture* ColorRTs[], ERenderTargetActions ColorAction)
	{
		check(NumColorRTs <= MaxSimultaneousRenderTargets);
		for (int32 Index = 0; Index < NumColorRTs; ++Index)
		{
			ColorRenderTargets[Index].RenderTarget = ColorRTs[Index];
			ColorRenderTargets[Index].Action = ColorAction;
		}
	}

	FRHIRenderPassInfo(FRHITexture* ColorRT, ERenderTargetActions ColorAction, FRHITexture* DepthRT,
		EDepthStencilTargetActions DepthAction,
		FExclusiveDepthStencil InDepthStencil = FExclusiveDepthStencil::DepthWrite_StencilWrite)
		: FRHIRenderPassInfo(ColorRT, ColorAction)
	{
		DepthStencilRenderTarget = {DepthRT, nullptr, DepthAction, InDepthStencil};
	}

	FRHIRenderPassInfo(FRHITexture* DepthRT, EDepthStencilTargetActions DepthAction,
		FExclusiveDepthStencil InDepthStencil = FExclusiveDepthStencil::DepthWrite_StencilWrite)
	{
		DepthStencilRenderTarget = {DepthRT, nullptr, DepthAction, InDepthStencil};
	}

	/** One more than the highest slot with a target. */
	int32 GetNumColorRenderTargets() const
	{
		int32 Num = MaxSimultaneousRenderTargets;
		while (Num > 0 && !ColorRenderTargets[Num - 1].RenderTarget)
		{
			--Num;
		}
		return Num;
	}

	FColorEntry ColorRenderTargets[MaxSimultaneousRenderTargets];
	FDepthStencilEntry DepthStencilRenderTarget;
};

/** Argument of CopyTexture. Size 0: the whole mip, from the positions on. */
struct FRHICopyTextureInfo
{
	FIntRect GetSourceRect() const
	{
		return FIntRect(SourcePosition.X, SourcePosition.Y, SourcePosition.X + Size.X, SourcePosition.Y + Size.Y);
	}
	FIntRect GetDestRect() const
	{
		return FIntRect(DestPosition.X, DestPosition.Y, DestPosition.X + Size.X, DestPosition.Y + Size.Y);
	}

	FIntVector Size = FIntVector(0, 0, 0);
	FIntVector SourcePosition = FIntVector(0, 0, 0); // texels of the source mip
	FIntVector DestPosition = FIntVector(0, 0, 0);
	uint32 SourceSliceIndex = 0;
	uint32 DestSliceIndex = 0;
	uint32 NumSlices = 1;
	uint32 SourceMipIndex = 0;
	uint32 DestMipIndex = 0;
	uint32 NumMips = 1; // sizes and positions halve per mip
};

/** Regions for RHIUpdateTexture2D: destination, source offset, size, in texels. */
struct FUpdateTextureRegion2D
{
	FUpdateTextureRegion2D() = default;
	FUpdateTextureRegion2D(uint32 InDestX, uint32 InDestY, int32 InSrcX, int32 InSrcY, uint32 InWidth, uint32 InHeight)
		: DestX(InDestX)
		, DestY(InDestY)
		, SrcX(InSrcX)
		, SrcY(InSrcY)
		, Width(InWidth)
		, Height(InHeight)
	{
	}

	uint32 DestX = 0;
	uint32 DestY = 0;
	int32 SrcX = 0;
	int32 SrcY = 0;
	uint32 Width = 0;
	uint32 Height = 0;
};

/** The conversion of ReadSurfaceData, and the mip and slice that it reads. */
class FReadSurfaceDataFlags
{
public:
	FReadSurfaceDataFlags(ERangeCompressionMode InCompressionMode = RCM_UNorm, ECubeFace InCubeFace = CubeFace_MAX)
		: CubeFace(InCubeFace)
		, CompressionMode(InCompressionMode)
	{
	}

	ECubeFace GetCubeFace() const { return CubeFace; }
	ERangeCompressionMode GetCompressionMode() const { return CompressionMode; }
	void SetCompressionMode(ERangeCompressionMode InMode) { CompressionMode = InMode; }
	void SetLinearToGamma(bool bValue) { bLinearToGamma = bValue; }
	bool GetLinearToGamma() const { return bLinearToGamma; }
	void SetOutputStencil(bool bValue) { bOutputStencil = bValue; }
	bool GetOutputStencil() const { return bOutputStencil; }
	void SetMip(uint8 InMipLevel) { MipLevel = InMipLevel; }
	uint8 GetMip() const { return MipLevel; }
	void SetArrayIndex(int32 InArrayIndex) { ArrayIndex = InArrayIndex; }
	int32 GetArrayIndex() const { return ArrayIndex; }

private:
	ECubeFace CubeFace = CubeFace_MAX;
	ERangeCompressionMode CompressionMode = RCM_UNorm;
	bool bLinearToGamma = true; // FColor of float formats only
	bool bOutputStencil = false;
	uint8 MipLevel = 0;
	int32 ArrayIndex = 0;
};
