// Random frames that share a cache of passes have the bits of frames without one.
#include <random>

#include "DispatchReuseTestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

/** Frames of random actions on a few textures, each frame a small change of the one before: every texture has the bits
 * of a frame without a cache, for any number of threads. */
TEST_F(DispatchReuse, RandomFramesHaveTheBitsOfFramesWithoutACache)
{
	struct FAction
	{
		int32 Kind, From, To;
		FPass Pass;
	};
	constexpr int32 NumTextures = 4;
	std::mt19937 Random(41);
	const auto Below = [&Random](int32 End)
	{
		return int32(Random() % uint32(End));
	};
	const auto MakeAction = [&]
	{
		FAction Action = {Below(6), Below(NumTextures), Below(NumTextures), {}};
		Action.Pass.Constant = float(Below(5)) - 1;
		Action.Pass.bDiscards = Action.Pass.Constant < 0;
		Action.Pass.bBlend = Below(4) == 0;
		Action.Pass.Rect =
			Below(2) ? FIntRect(0, 0, 40, 24) : FIntRect(Below(20), Below(12), 20 + Below(20), 13 + Below(11));
		Action.Pass.Sampler.AddressU = EKernelAddress(Below(2));
		return Action;
	};
	const auto RunFrame = [&](const std::vector<FAction>& Frame)
	{
		std::vector<FTextureRHIRef> Textures;
		for (int32 Index = 0; Index < NumTextures; ++Index)
		{
			Textures.push_back(MakeTexture(FIntPoint(40, 24), PF_R32_FLOAT));
			Textures.back()->Fill(FLinearColor(float(Index), 0, 0, 0));
		}
		for (const FAction& Action : Frame)
		{
			FRHITexture& From = *Textures[size_t(Action.From)];
			FRHITexture& To = *Textures[size_t(Action.To)];
			FPass Pass = Action.Pass;
			Pass.Input = Action.From != Action.To ? &From : nullptr;
			switch (Action.Kind)
			{
			case 0:
				Dispatch(Pass, To);
				break;
			case 1:
				Dispatch(Pass, To, &AddToSome);
				break;
			case 2:
				RHICmdList.CopyTexture(&From, &To, FRHICopyTextureInfo());
				break;
			case 3:
				To.WriteTexel(Pass.Rect.Min.X, Pass.Rect.Min.Y, FLinearColor(Pass.Constant, 0, 0, 0));
				break;
			default:
				Draw(Pass, To);
			}
		}
		std::vector<float> All;
		for (const FTextureRHIRef& Texture : Textures)
		{
			const std::vector<float> Values = Read(*Texture);
			All.insert(All.end(), Values.begin(), Values.end());
		}
		return All;
	};
	std::vector<FAction> Frame(12);
	std::generate(Frame.begin(), Frame.end(), MakeAction);
	uint64 NumReused = 0;
	for (int32 Number = 0; Number < 300; ++Number)
	{
		Frame[size_t(Below(int32(Frame.size())))] = MakeAction();
		const FScopedCVar Threads(TEXT("r.Drydock.Threads"), 1 + Number % 3);
		const std::vector<float> Expected = RunFrame(Frame);
		RHICmdList.ResetCounters();
		Cache.BeginFrame();
		const FScopedReuse Scope(&Cache);
		ASSERT_EQ(Expected, RunFrame(Frame)) << "frame " << Number;
		NumReused += RHICmdList.GetCounters().Reused;
	}
	EXPECT_GT(NumReused, 300u);
}
