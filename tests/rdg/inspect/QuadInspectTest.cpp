// Pixels that run by quads are looked into like others: the three beside them run with them, and are not what is told
// of.
#include <gtest/gtest.h>

#include "DebuggedShader.h"
#include "InspectTestUtils.h"
#include "KernelCheck.h"
#include "LineCoverage.h"
#include "TraceRecorder.h"

#include <cmath>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr uint64_t MaxSteps = 1'000'000;

/** The values that variables are given by one pixel, the last of each. */
std::map<std::string, double> ValuesOf(const FPixelTrace& Trace)
{
	std::map<std::string, double> Values;
	for (const FTraceLine& Line : Trace.Lines)
	{
		for (const FTraceEvent& Event : Line.Events)
		{
			if (Event.Kind == ETraceEvent::Value)
			{
				Values[Event.Name] = Event.Value.Reals.at(0);
			}
		}
	}
	return Values;
}

constexpr const char* Steps = "float V = SvPosition.x * SvPosition.x;\n"
							  "float Step = ddx_fine(V);\n"
							  "if (SvPosition.y > 2)\n{\n\tdiscard;\n}\n"
							  "float After = Step * 2;\n"
							  "OutColor = float4(After, ddy(SvPosition.y), 0, 1);";

TEST(QuadInspect, ATraceKnowsTheNeighbours)
{
	FShaderHarness Harness = MakeInspectedPixel(Steps);
	FInspectedShader& Shader = Harness.Inspect();
	for (int32_t X = 0; X < InspectWidth; ++X)
	{
		for (const bool bDouble : {false, true})
		{
			const double Left = double(X & ~1) + 0.5;
			const FPixelTrace Trace = TracePixel(Shader, Harness.GetArgs(), {X, 1, 0}, bDouble, MaxSteps);
			EXPECT_EQ((Left + 1) * (Left + 1) - Left * Left, ValuesOf(Trace).at("Step")) << X;
			EXPECT_EQ(2 * ValuesOf(Trace).at("Step"), Trace.Targets.at(0).at(0)) << X;
			EXPECT_EQ(1, Trace.Targets.at(0).at(1)) << X;
		}
	}
}

TEST(QuadInspect, ADiscardedPixelIsSeenUpToThere)
{
	FShaderHarness Harness = MakeInspectedPixel(Steps);
	FInspectedShader& Shader = Harness.Inspect();
	const FPixelTrace Trace = TracePixel(Shader, Harness.GetArgs(), {1, 2, 0}, false, MaxSteps);
	EXPECT_TRUE(Trace.bDiscarded);
	EXPECT_EQ(1u, ValuesOf(Trace).count("Step"));
	EXPECT_EQ(0u, ValuesOf(Trace).count("After"));

	const FLineCoverage Coverage = CollectLineCoverage(Shader, MakeBound(Harness), Harness.GetArgs(), InspectWhole);
	const std::map<int, FLineCount>& Lines = Coverage.Files.at("/Test/Shader.usf");
	EXPECT_EQ(24u, Coverage.Threads);
	EXPECT_EQ(24u, Lines.at(6).Threads);
	EXPECT_EQ(12u, Lines.at(9).Threads);
	EXPECT_EQ(12u, Lines.at(11).Threads);
}

TEST(QuadInspect, WhatHelpersComputeIsNobodysFault)
{
	// 1 / (x - 5) is infinite for the column behind the last one that is drawn.
	FShaderHarness Harness =
		MakeInspectedPixel("float V = 1 / (floor(SvPosition.x) - 5);\nOutColor = float4(ddx(V), 0, 0, 1);");
	FInspectedShader& Shader = Harness.Inspect();
	FCheckSet Checks;
	Checks.bOn[size_t(ECheck::NonFinite)] = true;
	const auto Count = [&](const FKernelTile& Whole)
	{
		uint64_t Threads = 0;
		for (const FCheckFinding& Finding :
			CheckThreads(Shader, MakeBound(Harness), Harness.GetArgs(), Whole, {}, Checks))
		{
			Threads += Finding.Line == 5 ? Finding.Threads : 0;
		}
		return Threads;
	};
	EXPECT_EQ(0u, Count({0, 0, 0, 5, 3, 1}));
	EXPECT_EQ(4u, Count(InspectWhole));
}

TEST(QuadInspect, ADebuggerSeesTheSameDifferences)
{
	FShaderHarness Harness = MakeInspectedPixel(Steps);
	FInspectedShader& Shader = Harness.Inspect();
	const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
	for (const std::array<int32_t, 3> At : {std::array<int32_t, 3>{0, 0, 0}, {5, 1, 0}, {2, 3, 0}})
	{
		const FDebuggedThread Thread = Debugged.Run(Harness.GetArgs(), InspectWhole, At, MaxSteps);
		const FPixelTrace Trace = TracePixel(Shader, Harness.GetArgs(), {At[0], At[1], At[2]}, false, MaxSteps);
		EXPECT_EQ(Trace.bDiscarded, Thread.bDiscarded);
		EXPECT_EQ(Trace.Targets, Thread.Targets);
	}
}

TEST(QuadInspect, ASampleShowsTheLevelThatItChose)
{
	FShaderHarness Harness = MakeInspectedPixel(
		"OutColor = Source.Sample(SourceSampler, SvPosition.xy * 3 / 16);", "SamplerState SourceSampler;");
	FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(16, 16, false, 5);
	for (int32_t Mip = 0; Mip < 5; ++Mip)
	{
		const int32_t Size = FTestTexture::GetSize(16, Mip);
		for (int32_t i = 0; i < Size * Size; ++i)
		{
			Source.Texel(i % Size, i / Size, Mip)[0] = float(i + Mip * 1000);
		}
	}
	Harness.Sampler.Filter = EKernelFilter::Trilinear;
	Harness.Request.bQuads = true;
	FInspectedShader& Shader = Harness.Inspect();
	const FPixelTrace Trace = TracePixel(Shader, Harness.GetArgs(), {2, 1, 0}, false, MaxSteps);
	bool bSeen = false;
	for (const FTraceLine& Line : Trace.Lines)
	{
		for (const FTraceEvent& Event : Line.Events)
		{
			if (Event.Kind == ETraceEvent::Sample)
			{
				bSeen = true;
				EXPECT_NEAR(std::log2(3.0), Event.Level, 1e-6);
				double Sum = 0;
				for (const FFootprintTexel& Texel : Event.Texels)
				{
					Sum += Texel.Weight * Texel.Value[0];
				}
				EXPECT_NEAR(Event.Value.Reals.at(0), Sum, 2000.0 / 256); // mips are blended in eight bits
			}
		}
	}
	EXPECT_TRUE(bSeen);
	EXPECT_EQ(1u, Trace.Taps);
}

} // namespace
