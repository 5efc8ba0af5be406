// The passes that make the kernel of convolution bloom. Source: engine files Bloom/*.usf (order and purpose).
#include "Bloom/PostProcessFFTBloomKernel.h"

#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "SceneViewState.h"
#include "Screen/PostProcessDownsample.h"
#include "ShaderParameterStruct.h"

#include <algorithm>
#include <array>
#include <vector>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarCacheKernel(TEXT("r.Bloom.CacheKernel"), 1,
	TEXT("FFT bloom keeps the transformed kernel for the next frame: 0 no, 1 yes (default)."), ECVF_RenderThreadSafe);

class FClampKernelCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FClampKernelCS);
	SHADER_USE_PARAMETER_STRUCT(FClampKernelCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FIntPoint, OutputSize)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, KernelConstants)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()
};

class FResizeKernelCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FResizeKernelCS);
	SHADER_USE_PARAMETER_STRUCT(FResizeKernelCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FIntPoint, OutputSize)
		SHADER_PARAMETER(FVector2f, KernelCenterUV)
		SHADER_PARAMETER(FVector2f, KernelSizeInverse)
		SHADER_PARAMETER(FIntPoint, LargestOffset)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FClampKernelCS, "/Engine/Private/PostProcessFFTBloom.usf", "ClampKernelCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FResizeKernelCS, "/Engine/Private/PostProcessFFTBloom.usf", "ResizeKernelCS", SF_Compute);

BEGIN_SHADER_PARAMETER_STRUCT(FSurveyParameters, )
	RDG_TEXTURE_ACCESS(Kernel, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(Center, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(Output, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FPackKernelConstantsParameters, )
	RDG_BUFFER_ACCESS(Center, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(CenterEnergy, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(ScatterEnergy, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(MaxScatter, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(Output, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

constexpr EPixelFormat KernelFormat = PF_A32B32G32R32F;

FVector4f& GetEntry(FRDGBufferRef Buffer, uint32 Index = 0)
{
	return reinterpret_cast<FVector4f*>(Buffer->GetRHI()->GetData())[Index];
}

/** As the shader makes them. */
float MakePositiveFinite(float Value)
{
	constexpr float MaxHalfFloat = 65504.0f;
	return Value > 0.0f ? std::min(Value, MaxHalfFloat) : 0.0f;
}

/** Body(X, Y, Color) of every texel, row by row: always the same order, so always the same sums. */
template<typename BodyType>
void ForEachTexel(FRHITexture& Kernel, const BodyType& Body)
{
	const FIntPoint Size = Kernel.GetSizeXY();
	std::vector<FLinearColor> Row(static_cast<size_t>(Size.X));
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		Kernel.ReadRow(0, Y, TArrayView<FLinearColor>(Row.data(), Size.X));
		for (int32 X = 0; X < Size.X; ++X)
		{
			const FLinearColor& Color = Row[static_cast<size_t>(X)];
			Body(X, Y,
				std::array{MakePositiveFinite(Color.R), MakePositiveFinite(Color.G), MakePositiveFinite(Color.B)});
		}
	}
}

using FKernelColor = std::array<float, 3>;

FVector4f FindCenter(FRHITexture& Kernel)
{
	FVector4f Center(0.0f, 0.0f, 0.0f, 0.0f);
	float Brightest = -1.0f;
	ForEachTexel(Kernel,
		[&](int32 X, int32 Y, const FKernelColor& Color)
		{
			const float Brightness = 0.3f * Color[0] + 0.59f * Color[1] + 0.11f * Color[2];
			if (Brightness > Brightest)
			{
				Brightest = Brightness;
				Center = FVector4f(static_cast<float>(X), static_cast<float>(Y), 0.0f, 0.0f);
			}
		});
	return Center;
}

bool IsCenter(const FVector4f& Center, int32 X, int32 Y)
{
	return Center.X == static_cast<float>(X) && Center.Y == static_cast<float>(Y);
}

/** Largest value of each channel beside the centre. */
FVector4f FindMaxScatter(FRHITexture& Kernel, const FVector4f& Center)
{
	FKernelColor Largest = {};
	ForEachTexel(Kernel,
		[&](int32 X, int32 Y, const FKernelColor& Color)
		{
			for (size_t Channel = 0; Channel < 3 && !IsCenter(Center, X, Y); ++Channel)
			{
				Largest[Channel] = std::max(Largest[Channel], Color[Channel]);
			}
		});
	return FVector4f(Largest[0], Largest[1], Largest[2], 0.0f);
}

/** Sums the centre, or all other texels. */
FVector4f SumEnergy(FRHITexture& Kernel, const FVector4f& Center, bool bOfCenter)
{
	std::array<double, 3> Sum = {};
	ForEachTexel(Kernel,
		[&](int32 X, int32 Y, const FKernelColor& Color)
		{
			for (size_t Channel = 0; Channel < 3 && IsCenter(Center, X, Y) == bOfCenter; ++Channel)
			{
				Sum[Channel] += static_cast<double>(Color[Channel]);
			}
		});
	return FVector4f(static_cast<float>(Sum[0]), static_cast<float>(Sum[1]), static_cast<float>(Sum[2]), 0.0f);
}

FRDGBufferRef CreateEntries(FRDGBuilder& GraphBuilder, uint32 NumEntries, const TCHAR* Name)
{
	return GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(sizeof(FVector4f), NumEntries), Name);
}

/** Survey(kernel, centre) gives what the pass writes. Center null: not known yet. */
template<typename SurveyType>
FRDGBufferRef AddSurveyPass(FRDGBuilder& GraphBuilder, FRDGEventName&& EventName, const TCHAR* Name,
	FRDGTextureRef Kernel, FRDGBufferRef Center, const SurveyType& Survey)
{
	FSurveyParameters* Parameters = GraphBuilder.AllocParameters<FSurveyParameters>();
	Parameters->Kernel = Kernel;
	Parameters->Center = Center;
	Parameters->Output = CreateEntries(GraphBuilder, 1, Name);
	GraphBuilder.AddPass(MoveTemp(EventName), Parameters, ERDGPassFlags::Compute,
		[Parameters, Survey](FRHIComputeCommandList&)
		{
			const FRDGBufferRef CenterBuffer = Parameters->Center;
			GetEntry(Parameters->Output) = Survey(*Parameters->Kernel->GetRHI(),
				CenterBuffer ? GetEntry(CenterBuffer) : FVector4f(0.0f, 0.0f, 0.0f, 0.0f));
		});
	return Parameters->Output;
}

/** All that is known of the kernel's energies, in EBloomKernelConstant's order. */
FRDGBufferRef AddKernelSurvey(FRDGBuilder& GraphBuilder, FRDGTextureRef Kernel)
{
	FPackKernelConstantsParameters* Parameters = GraphBuilder.AllocParameters<FPackKernelConstantsParameters>();
	const FRDGBufferRef Center =
		AddSurveyPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.FindKernelCenter"), TEXT("Bloom.KernelCenter"), Kernel,
			nullptr, [](FRHITexture& Texture, const FVector4f&) { return FindCenter(Texture); });
	Parameters->Center = Center;
	Parameters->MaxScatter = AddSurveyPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.SurveyMaxScatterDispersion"),
		TEXT("Bloom.MaxScatterDispersion"), Kernel, Center,
		[](FRHITexture& Texture, const FVector4f& Position) { return FindMaxScatter(Texture, Position); });
	Parameters->CenterEnergy = AddSurveyPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.SurveyKernelCenterEnergy"),
		TEXT("Bloom.KernelCenterEnergy"), Kernel, Center,
		[](FRHITexture& Texture, const FVector4f& Position) { return SumEnergy(Texture, Position, true); });
	Parameters->ScatterEnergy = AddSurveyPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.SumScatterDispersionEnergy"),
		TEXT("Bloom.ScatterDispersionEnergy"), Kernel, Center,
		[](FRHITexture& Texture, const FVector4f& Position) { return SumEnergy(Texture, Position, false); });
	Parameters->Output =
		CreateEntries(GraphBuilder, static_cast<uint32>(EBloomKernelConstant::MAX), TEXT("Bloom.KernelConstants"));
	GraphBuilder.AddPass(RDG_EVENT_NAME("FFTBloom.PackKernelConstants"), Parameters, ERDGPassFlags::Compute,
		[Parameters](FRHIComputeCommandList&)
		{
			const FVector4f Scatter = GetEntry(Parameters->ScatterEnergy);
			const auto Set = [&](EBloomKernelConstant Constant, const FVector4f& Value)
			{
				GetEntry(Parameters->Output, static_cast<uint32>(Constant)) = Value;
			};
			Set(EBloomKernelConstant::Center, GetEntry(Parameters->Center));
			Set(EBloomKernelConstant::Total, GetEntry(Parameters->CenterEnergy) + Scatter);
			Set(EBloomKernelConstant::Scatter, Scatter);
			Set(EBloomKernelConstant::MaxScatter, GetEntry(Parameters->MaxScatter));
		});
	return Parameters->Output;
}

/** How often the texels of a line are read where NumPixels pixels take what ResizeKernelCS gives them. */
std::vector<double> CountReads(int32 NumTexels, float CenterUV, float SizeInverse, int32 NumPixels)
{
	std::vector<double> Reads(static_cast<size_t>(NumTexels));
	for (int32 Pixel = 0; Pixel < NumPixels; ++Pixel)
	{
		const float Forward = CenterUV + static_cast<float>(Pixel) * SizeInverse;
		const float UV = Forward <= 1.0f ? Forward : CenterUV + static_cast<float>(Pixel - NumPixels) * SizeInverse;
		if (UV >= 0.0f && UV <= 1.0f)
		{
			const double Place = FMath::Clamp(static_cast<double>(UV) * NumTexels - 0.5, 0.0, NumTexels - 1.0);
			const int32 First = static_cast<int32>(Place);
			Reads[static_cast<size_t>(First)] += 1.0 - (Place - First);
			Reads[static_cast<size_t>(FMath::Min(First + 1, NumTexels - 1))] += Place - First;
		}
	}
	return Reads;
}

/** The sum of the whole kernel after resizing, computed from the texture before it. */
FVector4f SumWholeKernel(FRHITexture& Texture, const FBloomFFTKernel& Wanted, FVector2f SizeInverse)
{
	const FIntPoint Size = Texture.GetSizeXY();
	const std::vector<double> ReadsX =
		CountReads(Size.X, static_cast<float>(Wanted.CenterUV.X), SizeInverse.X, Wanted.WholeSize.X);
	const std::vector<double> ReadsY =
		CountReads(Size.Y, static_cast<float>(Wanted.CenterUV.Y), SizeInverse.Y, Wanted.WholeSize.Y);
	std::array<double, 3> Sum = {};
	ForEachTexel(Texture,
		[&](int32 X, int32 Y, const FKernelColor& Color)
		{
			for (size_t Channel = 0; Channel < Sum.size(); ++Channel)
			{
				Sum[Channel] += static_cast<double>(Color[Channel]) * ReadsX[static_cast<size_t>(X)] *
								ReadsY[static_cast<size_t>(Y)];
			}
		});
	return FVector4f(static_cast<float>(Sum[0]), static_cast<float>(Sum[1]), static_cast<float>(Sum[2]), 0.0f);
}

FVector2f InvertSize(FVector2D Size)
{
	return FVector2f(static_cast<float>(1.0 / Size.X), static_cast<float>(1.0 / Size.Y));
}

FRDGTextureRef CreateKernelTexture(FRDGBuilder& GraphBuilder, FIntPoint Extent, const TCHAR* Name)
{
	return GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, KernelFormat, FClearValueBinding::None,
										  TexCreate_ShaderResource | TexCreate_UAV),
		Name);
}

FRDGTextureRef AddClampKernelPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FRDGTextureRef Kernel, FRDGBufferRef Constants)
{
	const FIntPoint Extent = Kernel->Desc.Extent;
	const FRDGTextureRef Output = CreateKernelTexture(GraphBuilder, Extent, TEXT("Bloom.ClampedKernel"));
	FClampKernelCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FClampKernelCS::FParameters>();
	PassParameters->OutputSize = Extent;
	PassParameters->InputTexture = Kernel;
	PassParameters->KernelConstants = GraphBuilder.CreateSRV(Constants);
	PassParameters->OutputTexture = GraphBuilder.CreateUAV(Output);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.ClampKernel %dx%d (CS)", Extent.X, Extent.Y),
		TShaderMapRef<FClampKernelCS>(View.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(Extent, FComputeShaderUtils::kGolden2DGroupSize));
	return Output;
}

/** Halved until a pixel of the picture covers no more than two texels. */
FRDGTextureRef AddDownsampleKernelPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FRDGTextureRef Kernel, FVector2D KernelSize)
{
	FScreenPassTexture Level(Kernel);
	while (Level.ViewRect.Width() > 2.0 * KernelSize.X && Level.ViewRect.Height() > 2.0 * KernelSize.Y)
	{
		FDownsamplePassInputs Inputs;
		Inputs.Name = TEXT("Bloom.DownsampleKernel");
		Inputs.SceneColor = Level;
		Inputs.Quality = EDownsampleQuality::Low;
		Level = AddDownsamplePass(GraphBuilder, View, Inputs);
	}
	return Level.Texture;
}

FRDGTextureRef AddResizeKernelPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, FRDGTextureRef Kernel,
	FVector2D KernelSize, const FBloomFFTKernel& Wanted)
{
	const FIntPoint Extent = Wanted.Domain.FrequencySize;
	const FRDGTextureRef Output = CreateKernelTexture(GraphBuilder, Extent, TEXT("Bloom.ResizedKernel"));
	FResizeKernelCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FResizeKernelCS::FParameters>();
	PassParameters->OutputSize = Extent;
	PassParameters->KernelCenterUV =
		FVector2f(static_cast<float>(Wanted.CenterUV.X), static_cast<float>(Wanted.CenterUV.Y));
	PassParameters->KernelSizeInverse = InvertSize(KernelSize);
	PassParameters->LargestOffset = FIntPoint(Wanted.WholeSize.X > Extent.X ? Wanted.Domain.ImageSize.X - 1 : Extent.X,
		Wanted.WholeSize.Y > Extent.Y ? Wanted.Domain.ImageSize.Y - 1 : Extent.Y);
	PassParameters->InputTexture = Kernel;
	PassParameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->OutputTexture = GraphBuilder.CreateUAV(Output);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.ResizeKernel %dx%d (CS)", Extent.X, Extent.Y),
		TShaderMapRef<FResizeKernelCS>(View.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(Extent, FComputeShaderUtils::kGolden2DGroupSize));
	return Output;
}

FBloomKernel AddBloomKernelPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomFFTKernel& Wanted)
{
	RDG_EVENT_SCOPE(GraphBuilder, "FFTBloomKernel");
	const FRDGTextureRef Picture = RegisterExternalTexture(GraphBuilder, Wanted.Texture, TEXT("Bloom.Kernel"));
	const FVector2D KernelSize = GetBloomKernelSize(Wanted.Domain.ImageSize, Picture->Desc.Extent, Wanted.Size);
	FBloomKernel Kernel;
	Kernel.Constants = AddKernelSurvey(GraphBuilder, Picture);
	const FRDGTextureRef Clamped = AddClampKernelPass(GraphBuilder, View, Picture, Kernel.Constants);
	const FRDGTextureRef Small = AddDownsampleKernelPasses(GraphBuilder, View, Clamped, KernelSize);
	if (Wanted.IsCut())
	{
		Kernel.Sum = AddSurveyPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.SumWholeKernel"), TEXT("Bloom.KernelSum"),
			Small, nullptr,
			[Wanted, SizeInverse = InvertSize(KernelSize)](FRHITexture& Texture, const FVector4f&)
			{ return SumWholeKernel(Texture, Wanted, SizeInverse); });
	}
	const FRDGTextureRef Resized = AddResizeKernelPass(GraphBuilder, View, Small, KernelSize, Wanted);
	Kernel.Spectrum =
		AddForwardFFTPasses(GraphBuilder, Wanted.Domain, FScreenPassTexture(Resized), TEXT("Bloom.KernelSpectrum"));
	return Kernel;
}

} // namespace

FVector2D GetBloomKernelSize(FIntPoint ImageSize, FIntPoint TextureSize, float Size)
{
	const double Width = FMath::Max(1.0, FMath::Clamp(static_cast<double>(Size), 0.0, 1.0) * ImageSize.X);
	return FVector2D(Width, FMath::Max(1.0, Width * TextureSize.Y / TextureSize.X));
}

FBloomKernel FindOrAddBloomKernel(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomFFTKernel& Wanted)
{
	auto* const ViewState = dynamic_cast<FSceneViewState*>(View.State);
	if (ViewState == nullptr || CVarCacheKernel.GetValueOnRenderThread() == 0)
	{
		return AddBloomKernelPasses(GraphBuilder, View, Wanted);
	}
	FBloomFFTKernel& Kept = ViewState->FindOrMakeCache<FBloomFFTKernel>();
	if (Kept.IsMadeFrom(Wanted) && Kept.Spectrum && Kept.Constants && (Kept.Sum || !Kept.IsCut()))
	{
		return {GraphBuilder.RegisterExternalTexture(Kept.Spectrum, TEXT("Bloom.KernelSpectrum")),
			GraphBuilder.RegisterExternalBuffer(Kept.Constants, TEXT("Bloom.KernelConstants")),
			Kept.Sum ? GraphBuilder.RegisterExternalBuffer(Kept.Sum, TEXT("Bloom.KernelSum")) : nullptr};
	}
	Kept = Wanted;
	Kept.Spectrum = nullptr;
	Kept.Constants = nullptr;
	Kept.Sum = nullptr;
	const FBloomKernel Kernel = AddBloomKernelPasses(GraphBuilder, View, Wanted);
	GraphBuilder.QueueTextureExtraction(Kernel.Spectrum, &Kept.Spectrum);
	GraphBuilder.QueueBufferExtraction(Kernel.Constants, &Kept.Constants);
	if (Kernel.Sum != nullptr)
	{
		GraphBuilder.QueueBufferExtraction(Kernel.Sum, &Kept.Sum);
	}
	return Kernel;
}

} // namespace Drydock
