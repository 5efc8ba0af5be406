// Makes the maps between the bases that positions of a screen pass are given in. Source: engine ScreenPass.cpp.
#include "ScreenTransform.h"

namespace
{

/** From a basis to the next one in the order of ETextureBasis. */
FScreenTransform StepToNextBasis(
	const FIntPoint& Extent, const FIntRect& Viewport, FScreenTransform::ETextureBasis Basis)
{
	return Basis == FScreenTransform::ETextureBasis::ScreenPosition ? FScreenTransform::ScreenPosToViewportUV
		   : Basis == FScreenTransform::ETextureBasis::ViewportUV
			   ? FScreenTransform(FVector2f(Viewport.Size()), FVector2f(Viewport.Min))
			   : FScreenTransform(FVector2f(1.0f / Extent.X, 1.0f / Extent.Y), FVector2f(0.0f, 0.0f));
}

} // namespace

FScreenTransform FScreenTransform::ChangeTextureBasisFromTo(
	const FIntPoint& TextureExtent, const FIntRect& TextureViewport, ETextureBasis SrcBasis, ETextureBasis DestBasis)
{
	check(SrcBasis < ETextureBasis::NumericalSpace && DestBasis < ETextureBasis::NumericalSpace);
	if (SrcBasis > DestBasis)
	{
		return Invert(ChangeTextureBasisFromTo(TextureExtent, TextureViewport, DestBasis, SrcBasis));
	}
	FScreenTransform Result = Identity;
	for (uint8 Basis = static_cast<uint8>(SrcBasis); Basis < static_cast<uint8>(DestBasis); ++Basis)
	{
		Result = Result * StepToNextBasis(TextureExtent, TextureViewport, static_cast<ETextureBasis>(Basis));
	}
	return Result;
}

FScreenTransform FScreenTransform::ChangeRectFromTo(const FVector2f& SourceOffset, const FVector2f& SourceExtent,
	const FVector2f& DestinationOffset, const FVector2f& DestinationExtent)
{
	const FVector2f Ratio = DestinationExtent / SourceExtent;
	return FScreenTransform(Ratio, DestinationOffset - SourceOffset * Ratio);
}

FScreenTransform FScreenTransform::ChangeRectFromTo(const FIntRect& SrcViewport, const FIntRect& DestViewport)
{
	return ChangeRectFromTo(FVector2f(SrcViewport.Min), FVector2f(SrcViewport.Size()), FVector2f(DestViewport.Min),
		FVector2f(DestViewport.Size()));
}

FScreenTransform FScreenTransform::SvPositionToViewportUV(const FIntRect& SrcViewport)
{
	return ChangeRectFromTo(
		FVector2f(SrcViewport.Min), FVector2f(SrcViewport.Size()), FVector2f(0.0f, 0.0f), FVector2f(1.0f, 1.0f));
}

FScreenTransform FScreenTransform::DispatchThreadIdToViewportUV(const FIntRect& SrcViewport)
{
	const FVector2f SizeInverse = FVector2f(1.0f, 1.0f) / FVector2f(SrcViewport.Size());
	return FScreenTransform(SizeInverse, SizeInverse * 0.5f);
}

FScreenTransform FScreenTransform::Invert(const FScreenTransform& A)
{
	const FVector2f ScaleInverse = FVector2f(1.0f, 1.0f) / A.Scale;
	return FScreenTransform(ScaleInverse, FVector2f(0.0f, 0.0f) - A.Bias * ScaleInverse);
}
