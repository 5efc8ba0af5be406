// A shader built for a debugger does what the interpreter does, bit for bit, and shows its author's names and lines.
#include <gtest/gtest.h>

#include "../shader/Compiler/CacheTestUtils.h"
#include "../shader/Compiler/ShaderHarness.h"
#include "DebugEmitter.h"
#include "DebugFunction.h"
#include "DebuggedShader.h"
#include "ShaderDirectories.h"
#include "TraceRecorder.h"

#include <algorithm>
#include <filesystem>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr uint64_t MaxSteps = 1'000'000;

/** Struct, matrices, arrays at run-time indices, out and inout parameters, overloads, statics, bools, loops, a switch,
 * names that C++ has other plans for. */
constexpr const char* Everything = R"(struct FTap
{
	float2 Offset;
	bool bUsed;
	float Weights[3];
};
static const float Table[4] = { 0.5, 0.25, -1, 3 };
static float Total;
float Scale;
float3x3 Turn;
float4 Colors[3];
Texture2D Source;
SamplerState SourceSampler;

FTap MakeTap(int Index, inout float Sum)
{
	FTap Tap = (FTap)0;
	Tap.Offset = float2(Index, Sum);
	Tap.bUsed = Index != 1;
	for (int i = 0; i < 3; ++i)
	{
		Tap.Weights[i] = Table[(Index + i) & 3] * Scale;
		Sum += Tap.Weights[i];
	}
	for (int i = 2; i >= 0; --i)
	{
		Sum *= 1 + 0.125 * i;
	}
	return Tap;
}

float Weigh(float Value)
{
	Total += Value;
	return Value * 2;
}

float Weigh(float2 Value)
{
	return Weigh(Value.x) + Weigh(Value.y);
}

float3x3 Twice(float3x3 M)
{
	M[1] *= 2;
	return M;
}

void Split(float Value, out float Whole, out float Part)
{
	Part = modf(Value, Whole);
}

void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0, out float4 OutOther : SV_Target1)
{
	uint2 Pixel = uint2(SvPosition.xy);
	if (Pixel.x == 3 && Pixel.y > 1)
	{
		discard;
	}
	float Sum = SvPosition.y;
	float3 requires = mul(Source.SampleLevel(SourceSampler, SvPosition.xy * 0.1, 0).rgb, Twice(Turn));
	FTap Taps[2];
	Taps[0] = MakeTap(Pixel.x, Sum);
	Taps[1] = MakeTap(1, Sum);
	bool3 Above = requires > float3(0.25, 0.5, 0.75);
	int xor = 0;
	switch (Pixel.y)
	{
	case 0:
		xor = 7;
		break;
	case 2:
	case 3:
		xor = -Pixel.x;
		break;
	default:
		xor = any(Above) ? 1 : 2;
		break;
	}
	float Whole, Part;
	Split(Sum * 3.3, Whole, Part);
	requires[Pixel.x % 3] += Taps[Pixel.x & 1].Weights[Pixel.y % 3];
	OutColor = float4(requires, Weigh(Taps[1].Offset)) + Colors[Pixel.y % 3];
	OutOther = float4(Taps[0].bUsed && Above.y ? Whole : Part, xor, Total, pow(abs(Sum), 0.3));
}
)";

void FillEverything(FShaderHarness& Harness)
{
	std::mt19937 Random(19);
	std::uniform_real_distribution<float> Any(-1, 2);
	Harness.SetFloats("Scale", {0.7f});
	Harness.SetFloats("Turn", {0.1f, 0.2f, 0.3f, 0, -0.4f, 0.5f, 0.6f, 0, 0.7f, 0.8f, 0.9f});
	std::vector<float> Colors(12);
	std::generate(Colors.begin(), Colors.end(), [&] { return Any(Random); });
	Harness.SetFloats("Colors", Colors);
	FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(5, 4);
	std::generate_n(Source.Texel(0, 0), 5 * 4 * 4, [&] { return Any(Random); });
	Harness.Targets.emplace_back(8, 5);
	Harness.Targets.emplace_back(8, 5);
}

void ExpectSame(FShaderHarness& Harness, int32_t X, int32_t Y)
{
	FInspectedShader& Inspected = Harness.Inspect();
	const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
	for (int32_t y = 0; y < Y; ++y)
	{
		for (int32_t x = 0; x < X; ++x)
		{
			const FPixelTrace Trace = TracePixel(Inspected, Harness.GetArgs(), {x, y, 0}, false, MaxSteps);
			const FDebuggedThread Thread = Debugged.Run(Harness.GetArgs(), {0, 0, 0, X, Y, 1}, {x, y, 0}, MaxSteps);
			EXPECT_EQ(Trace.bDiscarded, Thread.bDiscarded) << x << ", " << y;
			EXPECT_EQ(Trace.Targets, Thread.Targets) << x << ", " << y;
			EXPECT_FALSE(Thread.Next);
		}
	}
}

TEST(DebuggedShader, DoesWhatTheInterpreterDoes)
{
	FShaderHarness Harness(Everything, "MainPS", EShaderStage::Pixel);
	FillEverything(Harness);
	ExpectSame(Harness, 8, 5);
}

TEST(DebuggedShader, StoresWhatAComputeShaderStores)
{
	FShaderHarness Harness(R"(struct FItem
{
	float4 Color;
	uint Count;
};
StructuredBuffer<FItem> Items;
RWStructuredBuffer<FItem> Results;
RWBuffer<float> Flat;
[numthreads(4, 2, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint Index : SV_GroupIndex)
{
	FItem Item;
	Item.Color = Items[Id.x].Color;
	Item.Count = Items[Id.x].Count;
	for (uint Round = 0; Round < Item.Count; ++Round)
	{
		Item.Color.xz = Item.Color.zx * 1.5 + Id.y;
	}
	Item.Count += Index;
	Results[Id.y * 4 + Id.x].Color = Item.Color;
	Results[Id.y * 4 + Id.x].Count = Item.Count;
	Flat[Id.y * 4 + Id.x] = dot(Item.Color, 1);
}
)",
		"MainCS", EShaderStage::Compute);
	std::vector<float> Items;
	for (uint32_t i = 0; i < 4; ++i)
	{
		Items.insert(Items.end(), {0.1f * float(i), 1, float(i) - 2, 0.3f, __builtin_bit_cast(float, 1 + i)});
	}
	Harness.SetFloatBuffer("Items", Items);
	Harness.Buffers["Results"].resize(8 * 5);
	Harness.Buffers["Flat"].resize(8);
	Harness.Run(0, 4, 2);
	const auto Expected = Harness.Buffers;
	Harness.Buffers["Results"].assign(8 * 5, 0);
	Harness.Buffers["Flat"].assign(8, 0);

	Harness.Inspect();
	const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
	for (int32_t i = 0; i < 8; ++i)
	{
		Debugged.Run(Harness.GetArgs(), {0, 0, 0, 4, 2, 1}, {i % 4, i / 4, 0}, MaxSteps);
	}
	EXPECT_EQ(Expected, Harness.Buffers);
}

TEST(DebuggedShader, HasTheAuthorsNamesAndLines)
{
	FShaderHarness Harness(Everything, "MainPS", EShaderStage::Pixel);
	FillEverything(Harness);
	const std::string Text = EmitDebugKernel(Harness.Inspect(), "MainPS");
	for (const char* const Part : {"struct FTap { ::float2 Offset; bool bUsed; DrydockArray<float, 3> Weights; };",
			 "static float Weigh(float Value)", "static float Weigh(::float2 Value)", "::FTap Tap = {};",
			 "static ::float3x3 Turn;", "static float Total;", "DrydockArray<::FTap, 2> Taps = {};", "int xor_ = {};",
			 "#line 51 \"/Test/Shader.usf\""})
	{
		EXPECT_NE(std::string::npos, Text.find(Part)) << Part << "\n" << Text;
	}
}

// Two loops with an i each: a debugger shows that of the loop it is in.
TEST(DebuggedShader, ANameOfTwoVariablesHasBracesAroundEach)
{
	FShaderHarness Harness(Everything, "MainPS", EShaderStage::Pixel);
	FillEverything(Harness);
	const FInspectedShader& Shader = Harness.Inspect();
	const std::vector<FSpirvFunction>& Functions = Shader.GetModule().Functions;
	const auto Found = std::find_if(
		Functions.begin(), Functions.end(), [](const FSpirvFunction& Function) { return Function.Name == "MakeTap"; });
	ASSERT_NE(Functions.end(), Found);
	std::vector<FDebugLocal> Counters;
	for (const FDebugLocal& Local : FindDebugLocals(Shader.GetProgram(), *Found, {}))
	{
		EXPECT_EQ(Local.Name == "i", Local.bScoped) << Local.Name;
		if (Local.bScoped)
		{
			Counters.push_back(Local);
		}
	}
	ASSERT_EQ(2u, Counters.size());
	EXPECT_LT(Counters[0].Last, Counters[1].First);
}

TEST(DebuggedShader, EndsWhereALoopDoesNot)
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
	Harness.Inspect();
	const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
	EXPECT_THROW(Debugged.Run(Harness.GetArgs(), {0, 0, 0, 1, 1, 1}, {0, 0, 0}, MaxSteps), FSpirvError);
}

/** A loop with an instruction in it and one without, which no limit of instructions ends. */
TEST(DebuggedShader, ALoopWithoutEndEndsByTheLimitOfTheRun)
{
	for (const std::string Loop :
		{"	uint n = 1; while (n != 0) { n |= 1; }\n", "	if (Id.x == 2) { while (true) {} }\n"})
	{
		FShaderHarness Harness("RWStructuredBuffer<uint> Out;\n[numthreads(4, 1, 1)]\n"
							   "void Main(uint3 Id : SV_DispatchThreadID)\n{\n" +
								   Loop + "	Out[0] = 1;\n}\n",
			"Main", EShaderStage::Compute);
		Harness.Buffers["Out"] = {0};
		Harness.Inspect();
		const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
		FKernelLimits Limits = *Harness.GetArgs().Limits;
		Limits.LoopTurns = 1000;
		const auto Run = [&](uint64_t Steps, bool bDebugged)
		{
			FKernelArgs Args = Harness.GetArgs();
			Args.Limits = &Limits;
			Debugged.Run(Args, {0, 0, 0, 4, 1, 1}, {2, 0, 0}, Steps, bDebugged);
		};
		try
		{
			Run(100'000'000'000, false);
			FAIL() << Loop;
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(6041, Error.GetDiagnostics().at(0).Code);
			EXPECT_EQ(5, Error.GetDiagnostics()[0].Line);
		}
		if (Loop.find("n |=") != std::string::npos)
		{
			EXPECT_THROW(Run(MaxSteps, true), FSpirvError) << "its own loops may go on";
		}
	}
}

TEST(DebuggedShader, ItsFilesAreGoneWithIt)
{
	FShaderHarness Harness(Everything, "MainPS", EShaderStage::Pixel);
	FillEverything(Harness);
	Harness.Inspect();
	const auto Count = []
	{
		const std::string Mine = "drydock-" + std::to_string(getpid()) + "-";
		int Folders = 0;
		for (const auto& Entry : std::filesystem::directory_iterator(GetTemporaryParent()))
		{
			Folders += Entry.path().filename().string().starts_with(Mine);
		}
		return Folders;
	};
	const int Before = Count();
	{
		const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
		EXPECT_EQ(Before + 1, Count());
	}
	EXPECT_EQ(Before, Count());
}

/** The module with other names of files. */
std::string RenameFiles(const std::vector<uint32_t>& Words, const std::string& Name)
{
	constexpr uint32_t OpSource = 3;
	constexpr uint32_t OpString = 7;
	std::vector<uint32_t> Result(Words.begin(), Words.begin() + 5);
	for (size_t At = 5; At < Words.size(); At += Words[At] >> 16)
	{
		const uint32_t Op = Words[At] & 0xffff;
		const auto First = Words.begin() + std::ptrdiff_t(At);
		if (Op == OpString)
		{
			std::vector<uint32_t> Text(Name.size() / 4 + 1, 0);
			std::copy(Name.begin(), Name.end(), reinterpret_cast<char*>(Text.data()));
			Result.insert(Result.end(), {uint32_t(Text.size() + 2) << 16 | OpString, Words[At + 1]});
			Result.insert(Result.end(), Text.begin(), Text.end());
		}
		else if (Op == OpSource && (Words[At] >> 16) > 3) // without its text
		{
			Result.insert(Result.end(), {3u << 16 | OpSource, Words[At + 1], Words[At + 2]});
		}
		else
		{
			Result.insert(Result.end(), First, First + std::ptrdiff_t(Words[At] >> 16));
		}
	}
	return {reinterpret_cast<const char*>(Result.data()), Result.size() * sizeof(uint32_t)};
}

TEST(DebuggedShader, ANameOfAFileIsNoCode)
{
	// A compiler joins the lines around the first backslash, and then the quote ends the name.
	const std::string Name = "a\\\n\"\n#ifndef P\n#define P\nstatic int Pwn = (__builtin_trap(), 0);\n#endif\n//";
	const FShaderHarness Source("RWTexture2D<float4> Out;\n[numthreads(1, 1, 1)]\nvoid Main()\n{\n"
								"\tOut[int2(0, 0)] = 1;\n}\n",
		"Main", EShaderStage::Compute);
	const FScratchFolder Folder;
	Folder.Add(
		"a\n#error injected.spv", RenameFiles(CompileToSpirv(FlattenShader(Source.Request), Source.Request), Name));
	const size_t NumDirectories = CountShaderDirectories();
	AddShaderDirectory("/DebuggedShaderTest", Folder.Path.string());
	FShaderHarness Harness("", "Main", EShaderStage::Compute);
	Harness.Request.VirtualPath = "/DebuggedShaderTest/a\n#error injected.spv";
	Harness.Request.GeneratedFiles.clear();
	Harness.Textures["Out"] = FTestTexture(1, 1);
	FInspectedShader& Inspected = Harness.Inspect();
	const std::string Cpp = EmitDebugKernel(Inspected, "Main");
	EXPECT_NE(std::string::npos, Cpp.find("#line 5 \"a\\\\\\\"#ifndef P#define P")) << Cpp;
	const FDebuggedShader Debugged(Harness.Request, Harness.GetReflection());
	Debugged.Run(Harness.GetArgs(), {0, 0, 0, 1, 1, 1}, {0, 0, 0}, MaxSteps);
	EXPECT_EQ(1.0f, Harness.Textures["Out"].Texel(0, 0)[0]);
	Harness.Run(4, 1, 1); // the kernel
	ForgetShaderDirectories(NumDirectories);
}

} // namespace
