// A pass that samples what it renders to reads what was there before it, for any number of threads.
#include <gtest/gtest.h>

#include "rdg/graph/Graph/GraphTestBuilder.h"
#include "ScreenPass.h"

using namespace Drydock;

namespace
{

constexpr int32 Width = 96;
constexpr int32 Height = 70;

float GetRamp(int32 X, int32 Y)
{
	return static_cast<float>(X + 1000 * Y);
}

/** Draws the left upper quarter of a ramp over the whole of it. */
FTextureRHIRef Magnify(FGraphTest& Graph)
{
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Extent = FIntPoint(Width, Height);
	const FRDGTextureRef Texture = Graph.Texture("X", Desc);
	const auto DrawRamp = [Texture](FRHICommandListImmediate&)
	{
		for (int32 Y = 0; Y < Height; ++Y)
		{
			for (int32 X = 0; X < Width; ++X)
			{
				Texture->GetRHI()->WriteTexel(X, Y, FLinearColor(GetRamp(X, Y), 0.0f, 0.0f, 0.0f));
			}
		}
	};
	Graph.Pass("Ramp").Renders("X").Does(DrawRamp);
	AddDrawTexturePass(*Graph.Builder, FScreenPassViewInfo(),
		FScreenPassTexture(Texture, FIntRect(0, 0, Width / 2, Height / 2)),
		FScreenPassRenderTarget(Texture, FIntRect(0, 0, Width, Height), ERenderTargetLoadAction::ELoad));
	Graph.Extract("X");
	Graph.Run();
	return Graph.Pooled.at("X")->GetRHI();
}

} // namespace

TEST(Feedback, ReadsFindWhatWasThereBeforeThePass)
{
	for (const int32 NumThreads : {1, 2, 8})
	{
		const FScopedConsoleVariable Threads(TEXT("r.Drydock.Threads"), NumThreads);
		FGraphTest Graph;
		const FTextureRHIRef Result = Magnify(Graph);
		for (int32 Y = 0; Y < Height; ++Y)
		{
			for (int32 X = 0; X < Width; ++X)
			{
				ASSERT_EQ(GetRamp(X / 2, Y / 2), Result->ReadTexel(X, Y).R) << X << ", " << Y << ", " << NumThreads;
			}
		}
	}
}

TEST(Feedback, IsAnErrorWhereValidationIsStrict)
{
	const FScopedConsoleVariable Strict(TEXT("r.RDG.Validation"), 2);
	FGraphTest Graph;
	try
	{
		Magnify(Graph);
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_EQ(RDGErrorHazard, Error.GetDiagnostics().at(0).Code);
	}
}
