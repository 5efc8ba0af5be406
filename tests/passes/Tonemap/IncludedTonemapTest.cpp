// The shipped tonemapper's shaders, included by their virtual paths: a table filled through the engine's parameters,
// and a film curve put behind exposure, tint and bloom.
#include "TonemapTestUtils.h"

#include "ToneReference.h"

#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphUtils.h"
#include "ShaderCore.h"
#include "WorkingColorSpace.h"

#include <random>

using namespace TonemapTest;
using PassReference::MaxDifference;

namespace
{

/** The parameters as the engine names them, and as plugins repeat them. */
class FIncludedLUTCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FIncludedLUTCS);
	SHADER_USE_PARAMETER_STRUCT(FIncludedLUTCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FWorkingColorSpaceShaderParameters, WorkingColorSpace)
		SHADER_PARAMETER(float, LUTSize)
		SHADER_PARAMETER(FVector4f, OverlayColor)
		SHADER_PARAMETER(FVector3f, ColorScale)
		SHADER_PARAMETER(FVector4f, ColorSaturation)
		SHADER_PARAMETER(FVector4f, ColorContrast)
		SHADER_PARAMETER(FVector4f, ColorGamma)
		SHADER_PARAMETER(FVector4f, ColorGain)
		SHADER_PARAMETER(FVector4f, ColorOffset)
		SHADER_PARAMETER(FVector4f, ColorSaturationShadows)
		SHADER_PARAMETER(FVector4f, ColorContrastShadows)
		SHADER_PARAMETER(FVector4f, ColorGammaShadows)
		SHADER_PARAMETER(FVector4f, ColorGainShadows)
		SHADER_PARAMETER(FVector4f, ColorOffsetShadows)
		SHADER_PARAMETER(FVector4f, ColorSaturationMidtones)
		SHADER_PARAMETER(FVector4f, ColorContrastMidtones)
		SHADER_PARAMETER(FVector4f, ColorGammaMidtones)
		SHADER_PARAMETER(FVector4f, ColorGainMidtones)
		SHADER_PARAMETER(FVector4f, ColorOffsetMidtones)
		SHADER_PARAMETER(FVector4f, ColorSaturationHighlights)
		SHADER_PARAMETER(FVector4f, ColorContrastHighlights)
		SHADER_PARAMETER(FVector4f, ColorGammaHighlights)
		SHADER_PARAMETER(FVector4f, ColorGainHighlights)
		SHADER_PARAMETER(FVector4f, ColorOffsetHighlights)
		SHADER_PARAMETER(float, ColorCorrectionShadowsMax)
		SHADER_PARAMETER(float, ColorCorrectionHighlightsMin)
		SHADER_PARAMETER(float, ColorCorrectionHighlightsMax)
		SHADER_PARAMETER(float, WhiteTemp)
		SHADER_PARAMETER(float, WhiteTint)
		SHADER_PARAMETER(float, BlueCorrection)
		SHADER_PARAMETER(float, ExpandGamut)
		SHADER_PARAMETER(float, ToneCurveAmount)
		SHADER_PARAMETER(float, FilmSlope)
		SHADER_PARAMETER(float, FilmToe)
		SHADER_PARAMETER(float, FilmShoulder)
		SHADER_PARAMETER(float, FilmBlackClip)
		SHADER_PARAMETER(float, FilmWhiteClip)
		SHADER_PARAMETER(uint32, bIsTemperatureWhiteBalance)
		SHADER_PARAMETER(FVector3f, MappingPolynomial)
		SHADER_PARAMETER(FVector3f, InverseGamma)
		SHADER_PARAMETER(uint32, OutputDevice)
		SHADER_PARAMETER(uint32, OutputGamut)
		SHADER_PARAMETER(float, ACESSceneColorMultiplier)
		SHADER_PARAMETER(FVector2f, OutputExtentInverse)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, RWOutputTexture)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters&, FShaderCompilerEnvironment& OutEnvironment)
	{
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZE"), 8);
	}
};

IMPLEMENT_GLOBAL_SHADER(FIncludedLUTCS, "/DrydockTests/IncludedCombineLUTs.usf", "CreateLUTCS", SF_Compute);

class FReinhardPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FReinhardPS);
	SHADER_USE_PARAMETER_STRUCT(FReinhardPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Bloom)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BloomTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BloomSampler)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
		SHADER_PARAMETER(FLinearColor, ColorScale0)
		SHADER_PARAMETER(float, bWriteLumaToAlpha)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FReinhardPS, "/DrydockTests/IncludedTonemap.usf", "ReinhardPS", SF_Pixel);

/** One range's grade out of four drawn vectors, with the whole picture's. */
ToneReference::FVec Combine(const FVector4f& Global, const FVector4f& Range)
{
	const double W = double(Global.W) * Range.W;
	return {Global.X * Range.X * W, Global.Y * Range.Y * W, Global.Z * Range.Z * W};
}

ToneReference::FVec CombineOffset(const FVector4f& Global, const FVector4f& Range)
{
	const double W = double(Global.W) + Range.W;
	return {Global.X + Range.X + W, Global.Y + Range.Y + W, Global.Z + Range.Z + W};
}

} // namespace

TEST(IncludedTonemap, TheEnginesParametersFillTheTable)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	constexpr int Size = 8;
	std::mt19937 Random(5); // the seed of the grades
	const auto Around = [&Random](double Middle, double Reach)
	{
		const auto Draw = [&]
		{
			return float(Middle + Reach * (2.0 * (Random() >> 8) / (1 << 24) - 1.0));
		};
		return FVector4f(Draw(), Draw(), Draw(), Draw());
	};

	PassTest::FPassRun Run(FImage(1, 1), EArithmetic::Float32);
	FIncludedLUTCS::FParameters* Parameters = Run.GraphBuilder.AllocParameters<FIncludedLUTCS::FParameters>();
	Parameters->WorkingColorSpace = GDefaultWorkingColorSpaceUniformBuffer.GetUniformBufferRef();
	Parameters->LUTSize = Size;
	Parameters->ColorScale = FVector3f(1.0f, 1.0f, 1.0f);
	Parameters->OverlayColor = FVector4f(0.0f, 0.0f, 0.0f, 0.0f); // no fade
	using FMember = FVector4f FIncludedLUTCS::FParameters::*;
	using FP = FIncludedLUTCS::FParameters;
	constexpr FMember Grades[5][4] = {{&FP::ColorSaturation, &FP::ColorSaturationShadows, &FP::ColorSaturationMidtones,
										  &FP::ColorSaturationHighlights},
		{&FP::ColorContrast, &FP::ColorContrastShadows, &FP::ColorContrastMidtones, &FP::ColorContrastHighlights},
		{&FP::ColorGamma, &FP::ColorGammaShadows, &FP::ColorGammaMidtones, &FP::ColorGammaHighlights},
		{&FP::ColorGain, &FP::ColorGainShadows, &FP::ColorGainMidtones, &FP::ColorGainHighlights},
		{&FP::ColorOffset, &FP::ColorOffsetShadows, &FP::ColorOffsetMidtones, &FP::ColorOffsetHighlights}};
	for (int Kind = 0; Kind < 5; ++Kind)
	{
		for (const FMember Member : Grades[Kind])
		{
			Parameters->*Member = Kind == 4 ? Around(0.01, 0.01) : Around(1.0, 0.1);
		}
	}
	Parameters->ColorCorrectionShadowsMax = 0.09f;
	Parameters->ColorCorrectionHighlightsMin = 0.5f;
	Parameters->ColorCorrectionHighlightsMax = 1.0f;
	Parameters->WhiteTemp = 6500.0f;
	Parameters->BlueCorrection = 0.6f;
	Parameters->ExpandGamut = 1.0f;
	Parameters->ToneCurveAmount = 1.0f;
	Parameters->FilmSlope = 0.88f;
	Parameters->FilmToe = 0.55f;
	Parameters->FilmShoulder = 0.26f;
	Parameters->FilmWhiteClip = 0.04f;
	Parameters->MappingPolynomial = FVector3f(0.0f, 1.0f, 0.0f);
	Parameters->InverseGamma = FVector3f(1.0f / 2.2f, 1.0f, 1.0f / 2.2f);
	Parameters->OutputExtentInverse = FVector2f(1.0f / (Size * Size), 1.0f / Size);
	FRDGTextureRef Output =
		Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(Size * Size, Size), PF_A32B32G32R32F,
										   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("Table"));
	Parameters->RWOutputTexture = Run.GraphBuilder.CreateUAV(Output);
	TShaderMapRef<FIncludedLUTCS> ComputeShader(Run.View.ShaderMap);
	FComputeShaderUtils::AddPass(
		Run.GraphBuilder, RDG_EVENT_NAME("Table"), ComputeShader, Parameters, FIntVector(Size, 1, 1));
	const FImage Table = Run.Execute(FScreenPassTexture(Output));

	std::array<ToneReference::FGrade, 3> Expected;
	for (int Range = 0; Range < 3; ++Range)
	{
		const auto Get = [&](int Kind)
		{
			return Combine(Parameters->*Grades[Kind][0], Parameters->*Grades[Kind][Range + 1]);
		};
		Expected[Range] = {Get(0), Get(1), Get(2), Get(3),
			CombineOffset(Parameters->*Grades[4][0], Parameters->*Grades[4][Range + 1])};
	}
	const auto Decode = [](double Position)
	{
		const auto ToLinear = [](double P)
		{
			return 0.18 * std::exp2((P - 444.0 / 1023.0) * 14.0);
		};
		return std::max(0.0, ToLinear(Position) - ToLinear(0.0));
	};
	double Worst = 0.0;
	for (int Y = 0; Y < Size; ++Y)
	{
		for (int X = 0; X < Size * Size; ++X)
		{
			const ToneReference::FVec Color = {
				Decode(X % Size / (Size - 1.0)), Decode(Y / (Size - 1.0)), Decode(X / Size / (Size - 1.0))};
			const ToneReference::FVec AP1 =
				ToneReference::ExpandGamut(ToneReference::Mul(ToneReference::Matrices().Rec709ToAP1, Color), 1);
			const ToneReference::FVec Film = ToneReference::FilmFromAP1(ToneReference::CorrectAll(AP1, Expected), {});
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Exact = ToneReference::EncodeSrgb(Film[Channel]) / 1.05;
				Worst = std::max(Worst, std::abs(Exact - Table.At(X, Y)[Channel]));
			}
		}
	}
	EXPECT_LT(Worst, 2e-4);
}

TEST(IncludedTonemap, AnotherCurveKeepsExposureTintAndBloom)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	const FImage Scene = FImage::Noise(17, 9);
	const FImage Glow = FImage::Noise(17, 9);
	PassTest::FPassRun Run(Scene, EArithmetic::Float32, PF_A32B32G32R32F);
	const FScreenPassTexture Bloom = Run.AddInput(Glow, PF_A32B32G32R32F, TEXT("Bloom"));
	const FScreenPassRenderTarget Output(
		Run.GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(FIntPoint(17, 9), PF_A32B32G32R32F, FClearValueBinding::None,
				TexCreate_RenderTargetable | TexCreate_ShaderResource),
			TEXT("Output")),
		ERenderTargetLoadAction::ENoAction);
	FReinhardPS::FParameters* Parameters = Run.GraphBuilder.AllocParameters<FReinhardPS::FParameters>();
	Parameters->View = Run.View.ViewUniformBuffer;
	Parameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Run.Input));
	Parameters->Bloom = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Bloom));
	Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters->ColorTexture = Run.Input.Texture;
	Parameters->ColorSampler = TStaticSamplerState<SF_Bilinear>::GetRHI();
	Parameters->BloomTexture = Bloom.Texture;
	Parameters->BloomSampler = TStaticSamplerState<SF_Bilinear>::GetRHI();
	Parameters->EyeAdaptationBuffer =
		Run.GraphBuilder.CreateSRV(Drydock::CreateEyeAdaptationBuffer(Run.GraphBuilder, 2.5f));
	Parameters->ColorScale0 = FLinearColor(1.0f, 0.5f, 0.25f, 1.0f);
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	TShaderMapRef<FReinhardPS> PixelShader(Run.View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(Run.GraphBuilder, GetGlobalShaderMap(GMaxRHIFeatureLevel),
		RDG_EVENT_NAME("Reinhard"), PixelShader, Parameters, FIntRect(0, 0, 17, 9));
	const FImage Result = Run.Execute(Output);

	const double Tint[3] = {1.0, 0.5, 0.25};
	for (int Y = 0; Y < 9; ++Y)
	{
		for (int X = 0; X < 17; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Light = 2.5 * (Scene.At(X, Y)[Channel] * Tint[Channel] + Glow.At(X, Y)[Channel]);
				EXPECT_NEAR(Light / (1.0 + Light), Result.At(X, Y)[Channel], 1e-6) << X << " " << Y;
			}
		}
	}
}
