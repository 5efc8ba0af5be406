// The pass that counts a histogram on the CPU. Source: engine file PostProcessHistogram.cpp; bucket maths of the
// engine's PostProcessHistogram.usf.
#include "Exposure/PostProcessHistogram.h"

#include "Exposure/ExposureMetering.h"
#include "PassFunctions.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"
#include "TileExecutor.h"

#include <cmath>
#include <vector>

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FHistogramParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, MeterMaskTexture)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, HistogramTexture)
END_SHADER_PARAMETER_STRUCT()

using FBuckets = std::array<double, Drydock::GHistogramSize>;

constexpr int32 RowsPerStrip = 16;

struct FHistogramWork
{
	FIntRect Rect; // of the input
	double OneOverPreExposure = 1.0;
	FEyeAdaptationParameters Parameters;
};

/** Red of the mask at a place of the view, bilinear, clamped at its edges. */
double SampleMask(FRHITexture& Mask, double U, double V)
{
	const FIntPoint Size = Mask.GetSizeXY();
	const double X = U * Size.X - 0.5, Y = V * Size.Y - 0.5;
	const double FloorX = std::floor(X), FloorY = std::floor(Y);
	const auto Read = [&](double AtX, double AtY)
	{
		return Mask.ReadTexelDouble(Drydock::ToIndex(AtX, Size.X), Drydock::ToIndex(AtY, Size.Y)).X;
	};
	const double Upper = Read(FloorX, FloorY) * (1.0 - (X - FloorX)) + Read(FloorX + 1.0, FloorY) * (X - FloorX);
	const double Lower =
		Read(FloorX, FloorY + 1.0) * (1.0 - (X - FloorX)) + Read(FloorX + 1.0, FloorY + 1.0) * (X - FloorX);
	return Upper * (1.0 - (Y - FloorY)) + Lower * (Y - FloorY);
}

void CountStrip(
	FRHITexture& Input, FRHITexture* Mask, const FHistogramWork& Work, int32 MinY, int32 MaxY, FBuckets& Buckets)
{
	std::vector<float> Row;
	std::vector<double> Means;
	for (int32 Y = MinY; Y < MaxY; ++Y)
	{
		Drydock::ReadMeanColors(Input, Work.Rect.Min.X, Work.Rect.Min.Y + Y, Work.Rect.Width(), Row, Means);
		for (int32 X = 0; X < Work.Rect.Width(); ++X)
		{
			const double Mean = Means[static_cast<size_t>(X)];
			if (std::isnan(Mean))
			{
				continue;
			}
			const double LogLuminance = Drydock::GetMeteredLogLuminance(
				Mean, Work.OneOverPreExposure, static_cast<double>(Work.Parameters.LuminanceMin));
			const Drydock::FBucketShare Share =
				Drydock::ShareBetweenBuckets(LogLuminance, static_cast<double>(Work.Parameters.HistogramScale),
					static_cast<double>(Work.Parameters.HistogramBias), Drydock::GHistogramSize);
			const double Weight =
				Mask != nullptr
					? std::max(0.0, SampleMask(*Mask, (X + 0.5) / Work.Rect.Width(), (Y + 0.5) / Work.Rect.Height()))
					: 1.0;
			const size_t First = static_cast<size_t>(Share.First);
			Buckets[First] += Share.FirstWeight * Weight;
			Buckets[First + 1] += Share.SecondWeight * Weight;
		}
	}
}

void WriteHistogram(FRHITexture& Texture, const FBuckets& Buckets)
{
	for (int32 Texel = 0; Texel < Drydock::GHistogramSize / 4; ++Texel)
	{
		const double* const Four = &Buckets[static_cast<size_t>(Texel) * 4];
		Texture.WriteTexelDouble(Texel, 0, FVector4(Four[0], Four[1], Four[2], Four[3]));
	}
}

void CountAndWrite(FRHITexture& Input, FRHITexture* Mask, const FHistogramWork& Work, FRHITexture& Output)
{
	const int32 Height = Work.Rect.Height();
	std::vector<FBuckets> Strips(static_cast<size_t>(FMath::DivideAndRoundUp(Height, RowsPerStrip)), FBuckets{});
	Input.EnsureMemory();
	if (Mask != nullptr)
	{
		Mask->EnsureMemory();
	}
	Output.EnsureMemory();
	Drydock::ForEachTile({0, 0, 0, 1, Height, 1}, FIntPoint(1, RowsPerStrip),
		[&](const Drydock::FKernelTile& Tile) {
			CountStrip(Input, Mask, Work, Tile.MinY, Tile.MaxY, Strips[static_cast<size_t>(Tile.MinY / RowsPerStrip)]);
		});
	const double Normalize = 1.0 / (static_cast<double>(Work.Rect.Width()) * Height);
	FBuckets Sums{};
	for (size_t Bucket = 0; Bucket < Sums.size(); ++Bucket)
	{
		for (const FBuckets& Strip : Strips)
		{
			Sums[Bucket] += Strip[Bucket];
		}
		Sums[Bucket] *= Normalize;
	}
	Sums[0] *= static_cast<double>(Work.Parameters.BlackHistogramBucketInfluence);
	WriteHistogram(Output, Sums);
}

} // namespace

FRDGTextureRef Drydock::BuiltInAddHistogramPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask)
{
	check(SceneColor.IsValid());
	const FRDGTextureRef Output = GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(Drydock::GHistogramSize / 4, 1), PF_A32B32G32R32F, FClearValueBinding::None,
			TexCreate_ShaderResource | TexCreate_UAV),
		TEXT("Histogram"));
	auto* PassParameters = GraphBuilder.AllocParameters<FHistogramParameters>();
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->MeterMaskTexture = MeterMask;
	PassParameters->HistogramTexture = GraphBuilder.CreateUAV(Output);
	const FHistogramWork Work{SceneColor.ViewRect, 1.0 / static_cast<double>(View.PreExposure), Parameters};
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("Histogram %dx%d (CPU)", SceneColor.ViewRect.Width(), SceneColor.ViewRect.Height()),
		PassParameters, ERDGPassFlags::Compute,
		[Input = SceneColor.Texture, MeterMask, Work, Output](FRHIComputeCommandList&)
		{ CountAndWrite(*Input->GetRHI(), MeterMask ? MeterMask->GetRHI() : nullptr, Work, *Output->GetRHI()); });
	return Output;
}

namespace Drydock
{

std::array<double, GHistogramSize> ReadHistogram(FRHITexture& Texture)
{
	std::array<double, GHistogramSize> Buckets{};
	for (int32 Texel = 0; Texel < GHistogramSize / 4; ++Texel)
	{
		const FVector4 Four = Texture.ReadTexelDouble(Texel, 0);
		const size_t First = static_cast<size_t>(Texel) * 4;
		Buckets[First] = Four.X;
		Buckets[First + 1] = Four.Y;
		Buckets[First + 2] = Four.Z;
		Buckets[First + 3] = Four.W;
	}
	return Buckets;
}

} // namespace Drydock
