// What a trace says of a thread: the lines it took, the values it made, the texels behind its samples.
#include <gtest/gtest.h>

#include "../shader/Compiler/ShaderHarness.h"
#include "TraceRecorder.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr uint64_t MaxSteps = 1'000'000;

FPixelTrace TraceAt(FShaderHarness& Harness, int32_t X, int32_t Y, bool bDouble = false)
{
	FInspectedShader& Shader = Harness.Inspect();
	return TracePixel(Shader, Harness.GetArgs(), {X, Y, 0}, bDouble, MaxSteps);
}

std::vector<int> LinesOf(const FPixelTrace& Trace)
{
	std::vector<int> Lines;
	for (const FTraceLine& Line : Trace.Lines)
	{
		Lines.push_back(Line.Line);
	}
	return Lines;
}

/** The value that a variable was given last; NaN: never. */
double LastOf(const FPixelTrace& Trace, const std::string& Name, size_t Component = 0)
{
	double Value = std::nan("");
	for (const FTraceLine& Line : Trace.Lines)
	{
		for (const FTraceEvent& Event : Line.Events)
		{
			if (Event.Kind == ETraceEvent::Value && Event.Name == Name)
			{
				Value = Event.Value.Reals.at(Component);
			}
		}
	}
	return Value;
}

constexpr const char* Branches = R"(float Scale;
float Half(float X)
{
	return X * 0.5;
}
void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)
{
	float Sum = 0;
	for (int i = 0; i < 3; ++i)
	{
		Sum += Half(SvPosition.x) + i;
	}
	if (Sum > 10)
	{
		Sum = 10;
	}
	else
	{
		Sum = Sum * Scale;
	}
	OutColor = float4(Sum, SvPosition.y, 0, 1);
}
)";

TEST(TracePixel, HasTheLinesOfThePathThatWasTaken)
{
	FShaderHarness Harness(Branches, "MainPS", EShaderStage::Pixel);
	Harness.SetFloats("Scale", {3});
	Harness.Targets.emplace_back(32, 4);
	const FPixelTrace Few = TraceAt(Harness, 1, 2);
	const std::vector<int> FewLines = LinesOf(Few);
	EXPECT_EQ(0, std::count(FewLines.begin(), FewLines.end(), 15)) << "the other branch";
	EXPECT_EQ(1, std::count(FewLines.begin(), FewLines.end(), 19));
	EXPECT_EQ(3, std::count(FewLines.begin(), FewLines.end(), 4)) << "three calls";
	// 3 * (1.5 / 2) + 0 + 1 + 2, times 3
	EXPECT_EQ(15.75, LastOf(Few, "Sum"));
	EXPECT_EQ(2.5, LastOf(Few, "OutColor", 1));
	ASSERT_EQ(1u, Few.Targets.size());
	EXPECT_EQ((std::vector<double>{15.75, 2.5, 0, 1}), Few.Targets[0]);

	const FPixelTrace Many = TraceAt(Harness, 20, 0);
	const std::vector<int> ManyLines = LinesOf(Many);
	EXPECT_EQ(1, std::count(ManyLines.begin(), ManyLines.end(), 15));
	EXPECT_EQ(0, std::count(ManyLines.begin(), ManyLines.end(), 19));
	EXPECT_EQ(10, LastOf(Many, "Sum"));
}

TEST(TracePixel, SaysWhichFunctionIsCalledAndWhatItGives)
{
	FShaderHarness Harness(Branches, "MainPS", EShaderStage::Pixel);
	Harness.SetFloats("Scale", {3});
	Harness.Targets.emplace_back(32, 4);
	const FPixelTrace Trace = TraceAt(Harness, 1, 2);
	int Calls = 0;
	int Returns = 0;
	for (const FTraceLine& Line : Trace.Lines)
	{
		EXPECT_EQ(Line.Line == 4 ? "Half" : "MainPS", Line.Function) << Line.Line;
		for (const FTraceEvent& Event : Line.Events)
		{
			Calls += Event.Kind == ETraceEvent::Call && Event.Name == "Half";
			const bool bReturn = Event.Kind == ETraceEvent::Return;
			Returns += bReturn;
			EXPECT_TRUE(!bReturn || (Event.Name == "Half" && Event.Value.Reals == std::vector<double>{0.75}));
		}
	}
	EXPECT_EQ(3, Calls);
	EXPECT_EQ(3, Returns);
}

TEST(TracePixel, InDoubleIsNearAndNotTheSame)
{
	FShaderHarness Harness(R"(void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)
{
	float Third = SvPosition.x / 3;
	OutColor = Third;
}
)",
		"MainPS", EShaderStage::Pixel);
	Harness.Targets.emplace_back(8, 8);
	const double InFloat = LastOf(TraceAt(Harness, 0, 0), "Third");
	const double InDouble = LastOf(TraceAt(Harness, 0, 0, true), "Third");
	EXPECT_EQ(double(0.5f / 3.0f), InFloat);
	EXPECT_EQ(0.5 / 3.0, InDouble);
}

TEST(TracePixel, TexelsOfAGatherAreItsComponents)
{
	std::mt19937 Random(20);
	std::uniform_real_distribution<float> Anywhere(-1.5f, 2.5f);
	FShaderHarness Harness("Texture2D Source;\nSamplerState SourceSampler;\nfloat2 UV;\n"
						   "void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)\n{\n"
						   "\tOutColor = Source.GatherGreen(SourceSampler, UV);\n}\n",
		"MainPS", EShaderStage::Pixel);
	Harness.Targets.emplace_back(1, 1);
	FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(7, 5);
	for (int32_t i = 0; i < 35 * 4; ++i)
	{
		Source.Texel(0, 0)[i] = Anywhere(Random);
	}
	for (int Round = 0; Round < 50; ++Round)
	{
		Harness.Sampler.AddressU = EKernelAddress(Random() % 4);
		Harness.Sampler.AddressV = EKernelAddress(Random() % 4);
		Harness.SetFloats("UV", {Anywhere(Random), Anywhere(Random)});
		const FPixelTrace Trace = TraceAt(Harness, 0, 0);
		std::vector<double> Gathered;
		for (const FTraceLine& Line : Trace.Lines)
		{
			for (const FTraceEvent& Event : Line.Events)
			{
				for (size_t i = 0; Event.Kind == ETraceEvent::Sample && i < Event.Texels.size(); ++i)
				{
					Gathered.insert(Gathered.end(), size_t(Event.Texels[i].Weight), Event.Texels[i].Value[1]);
				}
			}
		}
		std::vector<double> Written = Trace.Targets.at(0);
		std::sort(Gathered.begin(), Gathered.end());
		std::sort(Written.begin(), Written.end());
		EXPECT_EQ(Written, Gathered) << "round " << Round;
	}
}

TEST(TracePixel, TexelsOfASampleAddUpToIt)
{
	constexpr const char* Text = R"(Texture2D Source;
SamplerState SourceSampler;
float2 UV;
void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)
{
	OutColor = Source.SampleLevel(SourceSampler, UV, 0);
}
)";
	std::mt19937 Random(19);
	std::uniform_real_distribution<float> Anywhere(-1.5f, 2.5f);
	FShaderHarness Harness(Text, "MainPS", EShaderStage::Pixel);
	Harness.Targets.emplace_back(1, 1);
	FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(7, 5);
	for (int32_t i = 0; i < 35 * 4; ++i)
	{
		Source.Texel(0, 0)[i] = Anywhere(Random);
	}
	for (int Round = 0; Round < 200; ++Round)
	{
		Harness.Sampler.AddressU = EKernelAddress(Random() % 4);
		Harness.Sampler.AddressV = EKernelAddress(Random() % 4);
		Harness.Sampler.Filter = EKernelFilter(Random() % 2);
		Harness.SetFloats("UV", {Anywhere(Random), Anywhere(Random)});
		const FPixelTrace Trace = TraceAt(Harness, 0, 0);
		ASSERT_EQ(1u, Trace.Taps);
		for (const FTraceLine& Line : Trace.Lines)
		{
			for (const FTraceEvent& Event : Line.Events)
			{
				if (Event.Kind != ETraceEvent::Sample)
				{
					continue;
				}
				EXPECT_EQ("Source", Event.Name);
				double Sum[4] = {};
				double Weight = 0;
				for (const FFootprintTexel& Texel : Event.Texels)
				{
					Weight += Texel.Weight;
					for (int c = 0; c < 4; ++c)
					{
						Sum[c] += Texel.Weight * Texel.Value[c];
					}
				}
				EXPECT_DOUBLE_EQ(1, Weight);
				for (size_t c = 0; c < 4; ++c)
				{
					EXPECT_NEAR(Sum[c], Event.Value.Reals.at(c), 1e-6) << "round " << Round;
				}
			}
		}
	}
}

TEST(TracePixel, SaysWhatIsUsedBeforeItIsWritten)
{
	FShaderHarness Harness(R"(void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)
{
	float3 Color;
	Color.r = 1;
	if (SvPosition.x > 2)
	{
		Color.gb = 2;
	}
	OutColor = float4(Color * 2, 1);
}
)",
		"MainPS", EShaderStage::Pixel);
	Harness.Targets.emplace_back(8, 8);
	const auto Faults = [&Harness](int32_t X)
	{
		std::vector<std::string> Found;
		for (const FTraceLine& Line : TraceAt(Harness, X, 0).Lines)
		{
			for (const FTraceEvent& Event : Line.Events)
			{
				if (Event.Kind == ETraceEvent::Fault)
				{
					Found.push_back(std::to_string(Line.Line) + " " + Event.Name);
				}
			}
		}
		return Found;
	};
	EXPECT_EQ((std::vector<std::string>{"9 'Color' is used before it is written (component 1)",
				  "9 'Color' is used before it is written (component 2)"}),
		Faults(0));
	EXPECT_TRUE(Faults(5).empty());
}

TEST(TracePixel, EndsWhereALoopDoesNot)
{
	FShaderHarness Harness(R"(float Step;
void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)
{
	float X = 0;
	while (X < 1)
	{
		X += Step;
	}
	OutColor = X;
}
)",
		"MainPS", EShaderStage::Pixel);
	Harness.SetFloats("Step", {0});
	Harness.Targets.emplace_back(1, 1);
	try
	{
		TraceAt(Harness, 0, 0);
		FAIL() << "it ended";
	}
	catch (const FSpirvError& Error)
	{
		EXPECT_STREQ("the shader did not end", Error.what());
		EXPECT_TRUE(Error.Line >= 5 && Error.Line <= 8) << Error.Line;
	}
}

/** A line that goes on and on is one line of the trace. */
TEST(TracePixel, ALoopInOneLineIsCut)
{
	FShaderHarness Harness("RWStructuredBuffer<uint> Out;\n[numthreads(1, 1, 1)]\nvoid Main()\n{\n"
						   "	uint n = 0; while (n < 600000) { ++n; }\n	Out[0] = n;\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Buffers["Out"] = {0};
	FInspectedShader& Shader = Harness.Inspect();
	const FPixelTrace Trace = TracePixel(Shader, Harness.GetArgs(), {0, 0, 0}, false, 100 * MaxSteps);
	EXPECT_TRUE(Trace.bCut);
	ASSERT_EQ(1u, Trace.Lines.size());
	EXPECT_EQ(MaxTraceEvents, Trace.Lines[0].Events.size());
}

} // namespace

TEST(TracePixel, AThreadOfAGroupSeesWhatTheOthersDid)
{
	const std::string Text = R"(
StructuredBuffer<float> In;
RWStructuredBuffer<float> Out;
groupshared float Sums[32];
float Halve(float X)
{
	GroupMemoryBarrierWithGroupSync();
	return X * 0.5;
}
[numthreads(32, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	Sums[I] = In[Id.x];
	GroupMemoryBarrierWithGroupSync();
	for (uint Half = 16; Half > 0; Half >>= 1)
	{
		if (I < Half)
		{
			Sums[I] += Sums[I + Half];
		}
		GroupMemoryBarrierWithGroupSync();
	}
	const float Total = Halve(Sums[0]) + WavePrefixSum(1.0);
	Out[Id.x] = Total;
}
)";
	FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
	std::vector<float> In(64);
	for (size_t i = 0; i < In.size(); ++i)
	{
		In[i] = float(i * i % 37);
	}
	Harness.SetFloatBuffer("In", In);
	Harness.Buffers["Out"].assign(64, 0);
	Harness.Run(0, 64, 1);
	for (const int32_t X : {0, 5, 31, 32, 63})
	{
		const float Sum = std::accumulate(In.begin() + X / 32 * 32, In.begin() + X / 32 * 32 + 32, 0.0f);
		EXPECT_EQ(double(Sum) * 0.5 + X % 32, LastOf(TraceAt(Harness, X, 0), "Total")) << X;
		EXPECT_EQ(double(Sum) * 0.5 + X % 32, LastOf(TraceAt(Harness, X, 0, true), "Total")) << X;
		EXPECT_EQ(Harness.BufferFloat("Out", size_t(X)), float(LastOf(TraceAt(Harness, X, 0), "Total"))) << X;
	}
}
