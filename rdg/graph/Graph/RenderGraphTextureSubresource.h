// Mips, array slices and planes of a texture, and ranges of them. Planes: 0 colour or depth, 1 stencil.
// Source: engine RenderGraphTextureSubresource.h.
#pragma once

#include "RenderGraphDefinitions.h"

struct FRDGTextureSubresource
{
	uint32 MipIndex = 0;
	uint32 ArraySlice = 0;
	uint32 PlaneSlice = 0;

	bool operator==(const FRDGTextureSubresource&) const = default;
};

/** Numbers of a texture's mips, slices and planes; gives every subresource an index (mip fastest, then slice, then
 * plane). */
struct FRDGTextureSubresourceLayout
{
	FRDGTextureSubresourceLayout() = default;
	explicit FRDGTextureSubresourceLayout(const FRDGTextureDesc& Desc)
		: NumMips(Desc.NumMips)
		, NumArraySlices(uint32(Desc.GetNumSlices()))
		, NumPlaneSlices(IsStencilFormat(Desc.Format) ? 2 : 1)
	{
	}

	uint32 GetSubresourceCount() const { return NumMips * NumArraySlices * NumPlaneSlices; }
	uint32 GetSubresourceIndex(FRDGTextureSubresource At) const
	{
		return At.MipIndex + NumMips * (At.ArraySlice + NumArraySlices * At.PlaneSlice);
	}
	FRDGTextureSubresource GetSubresource(uint32 Index) const
	{
		return {Index % NumMips, Index / NumMips % NumArraySlices, Index / (NumMips * NumArraySlices)};
	}

	bool operator==(const FRDGTextureSubresourceLayout&) const = default;

	uint32 NumMips = 1;
	uint32 NumArraySlices = 1;
	uint32 NumPlaneSlices = 1;
};

/** A box of subresources. */
struct FRDGTextureSubresourceRange
{
	FRDGTextureSubresourceRange() = default;
	explicit FRDGTextureSubresourceRange(FRDGTextureSubresourceLayout Layout)
		: NumMips(Layout.NumMips)
		, NumArraySlices(Layout.NumArraySlices)
		, NumPlaneSlices(Layout.NumPlaneSlices)
	{
	}

	bool operator==(const FRDGTextureSubresourceRange&) const = default;

	bool IsWholeResource(const FRDGTextureSubresourceLayout& Layout) const
	{
		return *this == FRDGTextureSubresourceRange(Layout);
	}

	/** Calls Function(FRDGTextureSubresource) for each. */
	template<typename TFunction>
	void EnumerateSubresources(TFunction Function) const
	{
		for (uint32 Plane = PlaneSlice; Plane < PlaneSlice + NumPlaneSlices; ++Plane)
		{
			for (uint32 Slice = ArraySlice; Slice < ArraySlice + NumArraySlices; ++Slice)
			{
				for (uint32 Mip = MipIndex; Mip < MipIndex + NumMips; ++Mip)
				{
					Function(FRDGTextureSubresource{Mip, Slice, Plane});
				}
			}
		}
	}

	uint32 MipIndex = 0;
	uint32 ArraySlice = 0;
	uint32 PlaneSlice = 0;
	uint32 NumMips = 1;
	uint32 NumArraySlices = 1;
	uint32 NumPlaneSlices = 1;
};
