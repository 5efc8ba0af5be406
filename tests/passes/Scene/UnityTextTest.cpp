// Text of Unity by drydock's header for it, against the formulas in double.
#include "PassTestUtils.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

#include <cmath>
#include <random>

namespace
{

using namespace PassTest;

BEGIN_SHADER_PARAMETER_STRUCT(FUnityParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, _MainTex_Texture)
	SHADER_PARAMETER_SAMPLER(SamplerState, _MainTex_Sampler)
	SHADER_PARAMETER(FVector4f, _MainTex_ST)
	SHADER_PARAMETER(float, _LuminanceThreshold)
	SHADER_PARAMETER(uint32, _Which)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FUnityExtractPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FUnityExtractPS);
	SHADER_USE_PARAMETER_STRUCT(FUnityExtractPS, FGlobalShader);
	using FParameters = FUnityParameters;
};

class FUnityAllPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FUnityAllPS);
	SHADER_USE_PARAMETER_STRUCT(FUnityAllPS, FGlobalShader);
	using FParameters = FUnityParameters;
};

IMPLEMENT_GLOBAL_SHADER(FUnityExtractPS, "/DrydockTests/UnityText.usf", "fragExtractBright", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FUnityAllPS, "/DrydockTests/UnityText.usf", "fragAll", SF_Pixel);

constexpr int Width = 9;
constexpr int Height = 5;

/** Random colours of 0 to 1.5. */
FImage MakePicture()
{
	std::mt19937 Random(11);
	FImage Image(Width, Height);
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		for (double& Channel : Image.At(Pixel % Width, Pixel / Width))
		{
			Channel = static_cast<double>(static_cast<float>(Random() % 1536) / 1024.0f);
		}
	}
	return Image;
}

template<typename T>
FImage Draw(const FImage& Image, uint32 Which)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	const FRDGTextureRef Output = Run.GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(Width, Height), PF_A32B32G32R32F, FClearValueBinding::None,
			TexCreate_RenderTargetable | TexCreate_ShaderResource),
		TEXT("Out"));
	FUnityParameters* const Parameters = Run.GraphBuilder.AllocParameters<FUnityParameters>();
	Parameters->_MainTex_Texture = Run.Input.Texture;
	Parameters->_MainTex_Sampler = TStaticSamplerState<SF_Point>::GetRHI();
	Parameters->_MainTex_ST = FVector4f(1.0f, 1.0f, 0.0f, 0.0f);
	Parameters->_LuminanceThreshold = 0.25f;
	Parameters->_Which = Which;
	Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
	FPixelShaderUtils::AddFullscreenPass(Run.GraphBuilder, Run.View.ShaderMap, RDG_EVENT_NAME("Unity"),
		TShaderMapRef<T>(Run.View.ShaderMap), Parameters, FIntRect(0, 0, Width, Height));
	return Run.Execute(FScreenPassTexture(Output));
}

template<typename F>
void ExpectPixels(const FImage& Result, const FImage& Image, F Compute)
{
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		const std::array<double, 4> Expected = Compute(Image.At(Pixel % Width, Pixel / Width));
		for (size_t Channel = 0; Channel < 4; ++Channel)
		{
			EXPECT_NEAR(Expected[Channel], Result.At(Pixel % Width, Pixel / Width)[Channel],
				1e-5 * std::max(1.0, std::abs(Expected[Channel])))
				<< Pixel << "." << Channel;
		}
	}
}

double GetLuminance(const FTexel& C)
{
	return 0.2125 * C[0] + 0.7154 * C[1] + 0.0721 * C[2];
}

} // namespace

TEST(UnityText, TheArticlesFunctionsExtractWhatIsBright)
{
	const FImage Image = MakePicture();
	ExpectPixels(Draw<FUnityExtractPS>(Image, 0), Image,
		[](const FTexel& C)
		{
			const double Value = std::clamp(GetLuminance(C) - 0.25, 0.0, 1.0);
			return std::array<double, 4>{C[0] * Value, C[1] * Value, C[2] * Value, C[3] * Value};
		});
}

TEST(UnityText, SamplesAndFunctionsAreUnitys)
{
	const FImage Image = MakePicture();
	ExpectPixels(Draw<FUnityAllPS>(Image, 0), Image,
		[](const FTexel& C) {
			return std::array<double, 4>{4 * C[0], 4 * C[1], 4 * C[2], 4 * C[3]};
		});
	ExpectPixels(Draw<FUnityAllPS>(Image, 1), Image,
		[](const FTexel& C)
		{
			const auto ToLinear = [](double X)
			{
				return X * (X * (X * 0.305306011 + 0.682171111) + 0.012522878);
			};
			return std::array<double, 4>{ToLinear(C[0]), ToLinear(C[1]), ToLinear(C[2]),
				0.0396819152 * C[0] + 0.458021790 * C[1] + 0.00609653955 * C[2]};
		});
	ExpectPixels(Draw<FUnityAllPS>(Image, 2), Image,
		[](const FTexel& C)
		{
			const auto ToGamma = [](double X)
			{
				return std::max(0.0, 1.055 * std::pow(X, 0.416666667) - 0.055);
			};
			return std::array<double, 4>{ToGamma(C[0]), ToGamma(C[1]), ToGamma(C[2]), C[0]};
		});
	// Encoding keeps a value below 1.
	FImage Below = Image;
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		for (double& Channel : Below.At(Pixel % Width, Pixel / Width))
		{
			Channel *= 0.625;
		}
	}
	ExpectPixels(Draw<FUnityAllPS>(Below, 3), Below,
		[](const FTexel& C) {
			return std::array<double, 4>{C[0], C[1], 2.5, 3.0};
		});
}
