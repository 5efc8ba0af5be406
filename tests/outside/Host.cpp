// Runs the four plugins on a small picture and compares every pixel with what the formulas say.
#include "CoreMinimal.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"

#include "InvertCompute.h"
#include "LiftSetting.h"
#include "StripesRaw.h"
#include "TintPixel.h"

#include <cmath>
#include <cstdio>
#include <functional>

namespace
{

constexpr int32 Width = 37;
constexpr int32 Height = 11;

FLinearColor SourceColor(int32 X, int32 Y)
{
	return FLinearColor(X / 64.0f, Y / 16.0f, (X + Y) / 128.0f, 0.5f);
}

/** Runs one pass on the source picture; true when every pixel is as expected, within what half floats resolve. */
bool RunPass(const char* Name,
	const std::function<FScreenPassTexture(FRDGBuilder&, const FScreenPassTexture&)>& AddPass,
	const std::function<FLinearColor(int32, int32)>& Expected)
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	const FIntPoint Extent(Width, Height);
	TRefCountPtr<IPooledRenderTarget> Result;
	{
		FRDGBuilder GraphBuilder(RHICmdList, RDG_EVENT_NAME("%s", Name));
		FRDGTextureRef Source =
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, PF_FloatRGBA, FClearValueBinding::None,
										   TexCreate_RenderTargetable | TexCreate_ShaderResource | TexCreate_UAV),
				TEXT("Source"));
		AddClearRenderTargetPass(GraphBuilder, Source, FLinearColor(0.0f, 0.0f, 0.0f, 0.0f));
		for (int32 Y = 0; Y < Height; ++Y)
		{
			for (int32 X = 0; X < Width; ++X)
			{
				AddClearRenderTargetPass(GraphBuilder, Source, SourceColor(X, Y), FIntRect(X, Y, X + 1, Y + 1));
			}
		}
		const FScreenPassTexture Output = AddPass(GraphBuilder, FScreenPassTexture(Source));
		GraphBuilder.QueueTextureExtraction(Output.Texture, &Result);
		GraphBuilder.Execute();
	}

	TArray<FLinearColor> Pixels;
	RHICmdList.ReadSurfaceData(
		Result->GetRHI(), FIntRect(0, 0, Width, Height), Pixels, FReadSurfaceDataFlags(RCM_MinMax));
	for (int32 Y = 0; Y < Height; ++Y)
	{
		for (int32 X = 0; X < Width; ++X)
		{
			const FLinearColor Pixel = Pixels[Y * Width + X];
			const FLinearColor Want = Expected(X, Y);
			const float Error = std::fmax(std::fmax(std::fabs(Pixel.R - Want.R), std::fabs(Pixel.G - Want.G)),
				std::fmax(std::fabs(Pixel.B - Want.B), std::fabs(Pixel.A - Want.A)));
			if (!(Error <= 1.0f / 1024.0f))
			{
				std::printf("%s: pixel (%d, %d) is (%g, %g, %g, %g), expected (%g, %g, %g, %g)\n", Name, X, Y, Pixel.R,
					Pixel.G, Pixel.B, Pixel.A, Want.R, Want.G, Want.B, Want.A);
				return false;
			}
		}
	}
	return true;
}

} // namespace

int main()
{
	const FLinearColor Tint(0.5f, 2.0f, 1.0f, 1.0f);
	const FLinearColor Stripe(1.0f, 0.25f, 0.0f, 1.0f);
	int32 Failed = 0;
	Failed += !RunPass(
		"Invert",
		[](FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input) { return AddInvertPass(GraphBuilder, Input); },
		[](int32 X, int32 Y)
		{
			const FLinearColor Color = SourceColor(X, Y);
			return FLinearColor(1.0f - Color.R, 1.0f - Color.G, 1.0f - Color.B, Color.A);
		});
	Failed += !RunPass(
		"Tint",
		[&](FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input)
		{ return AddTintPass(GraphBuilder, Input, Tint); },
		[&](int32 X, int32 Y)
		{
			const FLinearColor Color = SourceColor(X, Y);
			return FLinearColor(Color.R * Tint.R, Color.G * Tint.G, Color.B * Tint.B, Color.A * Tint.A);
		});
	Failed += !RunPass(
		"Stripes",
		[&](FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input)
		{ return AddStripePass(GraphBuilder, Input, 5, Stripe); },
		[&](int32 X, int32 Y) { return X < 5 ? Stripe : SourceColor(X, Y); });
	FPostProcessSettings Settings;
	SetOutsideLift(Settings, 0.375f);
	Failed += !RunPass(
		"Lift",
		[&](FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input)
		{ return AddLiftPass(GraphBuilder, Input, Settings); },
		[](int32 X, int32 Y)
		{
			const FLinearColor Color = SourceColor(X, Y);
			return FLinearColor(Color.R + 0.375f, Color.G + 0.375f, Color.B + 0.375f, Color.A);
		});
	std::printf("%d passed, %d failed\n", 4 - Failed, Failed);
	return Failed == 0 ? 0 : 1;
}
