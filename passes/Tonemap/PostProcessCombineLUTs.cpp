// The pass that fills the combined table, and the parameters of its maths. Source: engine file
// PostProcessCombineLUTs.cpp.
#include "Tonemap/PostProcessCombineLUTs.h"

#include "HAL/IConsoleManager.h"
#include "PassFunctions.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/ScreenShaderPass.h"
#include "Screen/TextureAssets.h"
#include "ShaderParameterStruct.h"
#include "Tonemap/ColorGrading.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<int32> CVarLUTSize(TEXT("r.LUT.Size"), 32,
	TEXT("Colours to a side of the combined colour grading table, 16 to 65; 32 by default."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarTonemapLUT(TEXT("r.Drydock.TonemapLUT"), 1,
	TEXT(
		"1: the tonemapper reads the combined colour grading table, as the engine's (default). 0: it evaluates grading "
		"and film curve for each pixel."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarSceneColorMultiplier(TEXT("r.HDR.Aces.SceneColorMultiplier"), 1.5f,
	TEXT("Factor before the ACES tone scales, which are darker than the film curve; 1.5 by default."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarLUTInput(TEXT("r.Drydock.LUTInput"), 0,
	TEXT("Positions of the combined colour grading table: 0 as the tonemapper reads it, logarithmic (default). 1 sRGB "
		 "codes, for drydock settings cube: the picture of such a run is wrong."),
	ECVF_RenderThreadSafe);

BEGIN_SHADER_PARAMETER_STRUCT(FCombineLUTParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FColorRemapParameters, Remap)
	SHADER_PARAMETER(uint32, bLUTInputEncoded)
END_SHADER_PARAMETER_STRUCT()

DRYDOCK_SCREEN_SHADERS(FCombineLUT, FCombineLUTParameters, Drydock::FColorRemapPermutation, RWOutputTexture);

IMPLEMENT_GLOBAL_SHADER(FCombineLUTPS, "/Drydock/Private/PostProcessColorRemap.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FCombineLUTCS, "/Drydock/Private/PostProcessColorRemap.usf", "MainCS", SF_Compute);

float EncodeSrgb(double Linear)
{
	return static_cast<float>(Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1.0 / 2.4) - 0.055);
}

FVector4f ToVector4(const FVector3f& Value)
{
	return FVector4f(Value.X, Value.Y, Value.Z, 0.0f);
}

void SetGrading(const Drydock::FColorGrading& Grading, FColorRemapParameters& Parameters)
{
	for (size_t Index = 0; Index < 3; ++Index)
	{
		const std::array<double, 3>& Row = Grading.WhiteBalance[Index];
		Parameters.WhiteBalance[Index] =
			FVector4f(static_cast<float>(Row[0]), static_cast<float>(Row[1]), static_cast<float>(Row[2]), 0.0f);
		Parameters.ColorSaturation[Index] = ToVector4(Grading.Saturation[Index]);
		Parameters.ColorContrast[Index] = ToVector4(Grading.Contrast[Index]);
		Parameters.ColorGamma[Index] = ToVector4(Grading.Gamma[Index]);
		Parameters.ColorGain[Index] = ToVector4(Grading.Gain[Index]);
		Parameters.ColorOffset[Index] = ToVector4(Grading.Offset[Index]);
	}
	Parameters.ColorRanges = FVector4f(Grading.ShadowsMax, Grading.HighlightsMin, Grading.HighlightsMax, 0.0f);
}

/** The picture of a legacy table as code values: pictures are loaded as linear light. Null where there is none. */
FRDGTextureRef RegisterLegacyLUT(FRDGBuilder& GraphBuilder, const UTexture* Asset)
{
	const FTextureRHIRef Picture = Drydock::FindTexturePixels(Asset);
	if (!Picture)
	{
		return nullptr;
	}
	const FIntPoint Size = Picture->GetSizeXY();
	std::vector<FLinearColor> Colors;
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			const FVector4 Linear = Picture->ReadTexelDouble(X, Y);
			Colors.push_back(FLinearColor(EncodeSrgb(Linear.X), EncodeSrgb(Linear.Y), EncodeSrgb(Linear.Z), 1.0f));
		}
	}
	const FTextureRHIRef Codes = Drydock::MakePictureTexture(Size, Colors, "ColorGradingLUT");
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Codes, TEXT("ColorGradingLUT")));
}

/** How many legacy tables there are; weights that belong to none go to the neutral one. */
int32 SetLegacyLUTs(
	FRDGBuilder& GraphBuilder, const FFinalPostProcessSettings& Settings, FColorRemapParameters& Parameters)
{
	FRDGTextureRef* const Textures[Drydock::MaxBlendedLUTs] = {&Parameters.ColorGradingLUT0,
		&Parameters.ColorGradingLUT1, &Parameters.ColorGradingLUT2, &Parameters.ColorGradingLUT3};
	float* const Weights[Drydock::MaxBlendedLUTs] = {&Parameters.ColorGradingLUTWeights.X,
		&Parameters.ColorGradingLUTWeights.Y, &Parameters.ColorGradingLUTWeights.Z,
		&Parameters.ColorGradingLUTWeights.W};
	Parameters.ColorGradingLUTWeights = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
	Parameters.NeutralLUTWeight = 0.0f;
	int32 Count = 0;
	for (const FFinalPostProcessSettings::FLUTEntry& Entry : Settings.ContributingLUTs)
	{
		const FRDGTextureRef Texture = Count < Drydock::MaxBlendedLUTs && Entry.Weight > 0.0f
										   ? RegisterLegacyLUT(GraphBuilder, Entry.LUT.Get())
										   : nullptr;
		if (Texture == nullptr)
		{
			Parameters.NeutralLUTWeight += Entry.Weight;
			continue;
		}
		*Textures[Count] = Texture;
		*Weights[Count++] = Entry.Weight;
	}
	return Count;
}

FScreenPassRenderTarget CreateTable(FRDGBuilder& GraphBuilder, EDisplayOutputFormat OutputDevice, bool bCompute)
{
	const int32 Size = Drydock::GetLUTSize();
	const bool bHighRange = OutputDevice >= EDisplayOutputFormat::HDR_ACES_1000nit_ST2084;
	const EPixelFormat Format = bHighRange ? PF_FloatRGBA : PF_A2B10G10R10;
	const FIntPoint Extent(Size * Size, Size);
	return Drydock::CreateScreenTarget(GraphBuilder,
		FRDGTextureDesc::Create2D(Extent, Format, FClearValueBinding::None, TexCreate_None),
		FIntRect(FIntPoint::ZeroValue, Extent), TEXT("CombineLUTs"), bCompute);
}

} // namespace

namespace Drydock
{

FColorRemap MakeColorRemap(FRDGBuilder& GraphBuilder, const FViewInfo& View)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FTonemapperOutputDeviceParameters Device = GetTonemapperOutputDeviceParameters();
	const FColorGrading Grading = MakeColorGrading(Settings);

	FColorRemap Remap;
	FColorRemapParameters& Parameters = Remap.Parameters;
	Parameters.FilmSlopeToeShoulderBlackClip =
		FVector4f(Settings.FilmSlope, Settings.FilmToe, Settings.FilmShoulder, Settings.FilmBlackClip);
	Parameters.FilmWhiteClip = Settings.FilmWhiteClip;
	Parameters.BlueCorrection = Settings.BlueCorrection;
	Parameters.ExpandGamut = Settings.ExpandGamut;
	Parameters.ToneCurveAmount = Settings.ToneCurveAmount;
	Parameters.InverseGamma = Device.InverseGamma;
	Parameters.OverlayColor =
		FVector4f(View.OverlayColor.R, View.OverlayColor.G, View.OverlayColor.B, View.OverlayColor.A);
	Parameters.ColorScale = FVector3f(View.ColorScale.R, View.ColorScale.G, View.ColorScale.B);
	Parameters.SceneColorMultiplier = CVarSceneColorMultiplier.GetValueOnRenderThread();
	Parameters.LUTSize = static_cast<float>(GetLUTSize());
	Parameters.ColorGradingLUTSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	SetGrading(Grading, Parameters);

	Remap.Permutation.Set<FColorGradingDimension>(!Grading.bNeutral);
	Remap.Permutation.Set<FLUTBlendCountDimension>(SetLegacyLUTs(GraphBuilder, Settings, Parameters));
	Remap.Permutation.Set<FOutputDeviceDimension>(Device.OutputDevice);
	return Remap;
}

int32 GetLUTSize()
{
	return FMath::Clamp(CVarLUTSize.GetValueOnRenderThread(), 16, 65);
}

bool IsTonemapLUTUsed()
{
	return CVarTonemapLUT.GetValueOnRenderThread() != 0;
}

} // namespace Drydock

FRDGTextureRef Drydock::BuiltInAddCombineLUTPass(FRDGBuilder& GraphBuilder, const FViewInfo& View)
{
	const Drydock::FColorRemap Remap = Drydock::MakeColorRemap(GraphBuilder, View);
	const bool bCompute = View.bUseComputePasses;
	const FScreenPassRenderTarget Table =
		CreateTable(GraphBuilder, Remap.Permutation.Get<Drydock::FOutputDeviceDimension>(), bCompute);
	FCombineLUTParameters Parameters;
	Parameters.Remap = Remap.Parameters;
	Parameters.bLUTInputEncoded = CVarLUTInput.GetValueOnRenderThread() != 0 ? 1 : 0;
	const FString Name = FString::Printf(TEXT("CombineLUTs %d"), Table.ViewRect.Height());
	return Drydock::AddScreenShaderPass<FCombineLUTPS, FCombineLUTCS>(GraphBuilder, View, {Name, Table, bCompute},
		Parameters, Remap.Permutation, &FCombineLUTCS::FParameters::RWOutputTexture)
		.Texture;
}
