// FScreenTransform: an affine map of 2D positions, and the bases that positions of a screen pass are given in. The map
// is one float4 to HLSL (xy scale, zw bias). Source: engine ScreenPass.h.
#pragma once

#include "CoreMinimal.h"
#include "ShaderParameterMacros.h"

struct FScreenPassTextureViewport;

/** p' = p * Scale + Bias. `A * B` applies A first; `A / B` applies A, then the inverse of B. Plain data, 16 bytes. */
class alignas(16) FScreenTransform
{
public:
	FVector2f Scale;
	FVector2f Bias;

	FScreenTransform() = default;
	constexpr FScreenTransform(const FVector2f& InScale, const FVector2f& InBias)
		: Scale(InScale)
		, Bias(InBias)
	{
	}

	/** The unit that positions are measured in. Neighbours convert by one transform each; the order is the engine's. */
	enum class ETextureBasis : uint8
	{
		ScreenPosition, // -1..1, y up, over the viewport
		ViewportUV,     // 0..1, y down, over the viewport
		TexelPosition,  // texels of the texture; centres at +0.5
		TextureUV,      // 0..1 over the texture's extent
		NumericalSpace,
	};

	static const FScreenTransform Identity;
	static const FScreenTransform ScreenPosToViewportUV;
	static const FScreenTransform ViewportUVToScreenPos;

	/** The transform from one basis of a texture's viewport to another. The first is defined in ScreenPass.cpp, where
	 * the viewport is known. */
	static DRYDOCK_API FScreenTransform ChangeTextureBasisFromTo(
		const FScreenPassTextureViewport& TextureViewport, ETextureBasis SrcBasis, ETextureBasis DestBasis);
	static DRYDOCK_API FScreenTransform ChangeTextureBasisFromTo(const FIntPoint& TextureExtent,
		const FIntRect& TextureViewport, ETextureBasis SrcBasis, ETextureBasis DestBasis);

	/** Between two rectangles: (p - Src.Min) / Src.Size * Dst.Size + Dst.Min. */
	static DRYDOCK_API FScreenTransform ChangeRectFromTo(const FVector2f& SourceOffset, const FVector2f& SourceExtent,
		const FVector2f& DestinationOffset, const FVector2f& DestinationExtent);
	static DRYDOCK_API FScreenTransform ChangeRectFromTo(const FIntRect& SrcViewport, const FIntRect& DestViewport);

	/** SV_POSITION (pixel centres at +0.5) to 0..1 over the rect. */
	static DRYDOCK_API FScreenTransform SvPositionToViewportUV(const FIntRect& SrcViewport);

	/** SV_DispatchThreadID (integers from 0) to 0..1 over the rect: the centre of the pixel. */
	static DRYDOCK_API FScreenTransform DispatchThreadIdToViewportUV(const FIntRect& SrcViewport);

	static DRYDOCK_API FScreenTransform Invert(const FScreenTransform& A);

	bool operator==(const FScreenTransform&) const = default;
};

inline constexpr FScreenTransform FScreenTransform::Identity(FVector2f(1.0f, 1.0f), FVector2f(0.0f, 0.0f));
inline constexpr FScreenTransform FScreenTransform::ScreenPosToViewportUV(
	FVector2f(0.5f, -0.5f), FVector2f(0.5f, 0.5f));
inline constexpr FScreenTransform FScreenTransform::ViewportUVToScreenPos(
	FVector2f(2.0f, -2.0f), FVector2f(-1.0f, 1.0f));

inline FVector2f operator*(const FVector2f& P, const FScreenTransform& AToB)
{
	return P * AToB.Scale + AToB.Bias;
}

inline FScreenTransform operator*(const FScreenTransform& AToB, const FScreenTransform& BToC)
{
	return FScreenTransform(AToB.Scale * BToC.Scale, AToB.Bias * BToC.Scale + BToC.Bias);
}

inline FScreenTransform operator*(const FScreenTransform& AToB, const FVector2f& Scale)
{
	return FScreenTransform(AToB.Scale * Scale, AToB.Bias * Scale);
}

inline FScreenTransform operator+(const FScreenTransform& AToB, const FVector2f& Bias)
{
	return FScreenTransform(AToB.Scale, AToB.Bias + Bias);
}

inline FScreenTransform operator-(const FScreenTransform& AToB, const FVector2f& Bias)
{
	return FScreenTransform(AToB.Scale, AToB.Bias - Bias);
}

inline FScreenTransform operator/(const FScreenTransform& AToB, const FScreenTransform& CToB)
{
	return AToB * FScreenTransform::Invert(CToB);
}

inline FScreenTransform operator/(const FScreenTransform& AToB, const FVector2f& Divisor)
{
	return FScreenTransform(AToB.Scale / Divisor, AToB.Bias / Divisor);
}

template<>
struct TShaderParameterTypeInfo<FScreenTransform>
	: Drydock::TNumericParameterTypeInfo<FScreenTransform, UBMT_FLOAT32, 1, 4, 16>
{
};
