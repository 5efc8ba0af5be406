// What widening the character mask costs by area: the native kernel's running sums, the separable shader, the
// article's double loop. 1920x1080; all variants alternate inside one measurement; medians of 7.
#include "HAL/IConsoleManager.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "Toon/CharaGlow.h"

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace Drydock;

namespace
{

constexpr int GRepetitions = 7;
const FIntPoint GSize(1920, 1080);

struct FVariant
{
	const char* Name;
	float Area;
	bool bNative;
	bool bAsPrinted;
	std::vector<double> Milliseconds = {};
};

class FPassTimer final : public IRDGObserver
{
public:
	void OnPassExecuted(
		int32_t, const FRDGPass&, double Milliseconds, const FPassCounters&, const std::vector<FRDGTexture*>&) override
	{
		Sum += Milliseconds;
	}
	double Sum = 0.0;
};

FTextureRHIRef MakeTexture(EPixelFormat Format, const FVector4& Inside)
{
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create2D(GSize, Format, FClearValueBinding::None, TexCreate_ShaderResource), TEXT("Input"));
	for (int32 Y = 0; Y < GSize.Y; ++Y)
	{
		for (int32 X = 0; X < GSize.X; ++X)
		{
			const bool bInside = (X - 960) * (X - 960) + (Y - 540) * (Y - 540) < 300 * 300;
			Texture->WriteTexelDouble(X, Y, bInside ? Inside : FVector4(0, 0, 0, 0));
		}
	}
	return Texture;
}

double Run(const FVariant& Variant, FTextureRHIRef Color, FTextureRHIRef Mask)
{
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.NativeKernels"))->Set(Variant.bNative ? 1 : 0);
	FPassTimer Timer;
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), GSize), GSize);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Bench"));
	GraphBuilder.SetObserver(&Timer);
	FSceneTextures SceneTextures;
	SceneTextures.GBufferD = GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Mask, TEXT("GBufferD")));
	FCharaGlowInputs Inputs;
	Inputs.SceneColor =
		FScreenPassTexture(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Color, TEXT("SceneColor"))));
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, &SceneTextures);
	Inputs.Area = Variant.Area;
	Inputs.bAsPrinted = Variant.bAsPrinted;
	TRefCountPtr<IPooledRenderTarget> Result;
	GraphBuilder.QueueTextureExtraction(AddCharaGlowPasses(GraphBuilder, View, Inputs).Texture, &Result);
	GraphBuilder.Execute();
	return Timer.Sum;
}

double Median(std::vector<double> Values)
{
	std::sort(Values.begin(), Values.end());
	return Values[Values.size() / 2];
}

} // namespace

int main()
{
	std::vector<FVariant> Variants = {
		{"native", 2.0f, true, false},
		{"native", 8.5f, true, false},
		{"native", 32.0f, true, false},
		{"shader", 2.0f, false, false},
		{"shader", 32.0f, false, false},
		{"as printed", 2.0f, false, true},
		{"as printed", 8.0f, false, true},
	};
	const FTextureRHIRef Color = MakeTexture(PF_FloatRGBA, FVector4(1, 1, 1, 1));
	const FTextureRHIRef Mask = MakeTexture(PF_B8G8R8A8, FVector4(0, 0, 1, 0));
	for (int Repetition = -1; Repetition < GRepetitions; ++Repetition)
	{
		for (FVariant& Variant : Variants)
		{
			const double Milliseconds = Run(Variant, Color, Mask);
			if (Repetition >= 0) // the first round warms up
			{
				Variant.Milliseconds.push_back(Milliseconds);
			}
		}
	}
	const double First = Median(Variants[0].Milliseconds);
	std::printf("CharaGlow at %dx%d, medians of %d\n\n| form | area | ms | times native area 2 |\n|---|---|---|---|\n",
		GSize.X, GSize.Y, GRepetitions);
	for (const FVariant& Variant : Variants)
	{
		const double Milliseconds = Median(Variant.Milliseconds);
		std::printf("| %s | %g | %.1f | %.2f |\n", Variant.Name, static_cast<double>(Variant.Area), Milliseconds,
			Milliseconds / First);
	}
	return 0;
}
