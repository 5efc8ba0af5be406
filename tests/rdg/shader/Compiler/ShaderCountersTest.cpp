// Append, Consume, IncrementCounter and DecrementCounter: kernels at every lane count and the interpreter against plain
// C++, in the order that drydock states; at the ends of a buffer; and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderForms.h"

#include <numeric>

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

namespace
{

std::string ErrorOfShader(const std::string& Declarations, const std::string& Body)
{
	FShaderHarness Harness(
		Declarations + "\n[numthreads(8, 1, 1)]\nvoid MainCS(uint3 Id : SV_DispatchThreadID)\n{\n" + Body + "\n}\n",
		"MainCS", EShaderStage::Compute);
	return ErrorOf([&Harness] { CompileShader(Harness.Request); });
}

} // namespace

TEST(ShaderCounters, AStreamIsCompactedInTheOrderOfThreads)
{
	// Who appends does so in the order of threads; those of a wave that append twice do so one time after the other.
	const std::string Text = R"(
struct FItem { float3 Position; uint Id; };
StructuredBuffer<uint> In;
AppendStructuredBuffer<FItem> Kept;
[numthreads(48, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	for (uint k = 0; k < In[Id.x] % 3; ++k)
	{
		FItem Item;
		Item.Position = float3(Id.x, k, 0.5);
		Item.Id = Id.x * 4 + k;
		Kept.Append(Item);
	}
}
)";
	constexpr uint32_t NumThreads = 96;
	std::vector<uint32_t> In(NumThreads);
	for (uint32_t i = 0; i < NumThreads; ++i)
	{
		In[i] = i * 2654435761u >> 16;
	}
	std::vector<uint32_t> Expected; // ids
	for (uint32_t Group = 0; Group < NumThreads; Group += 48)
	{
		for (uint32_t Wave = 0; Wave < 48; Wave += 32)
		{
			for (uint32_t k = 0; k < 2; ++k)
			{
				for (uint32_t i = Group + Wave; i < Group + std::min(Wave + 32, 48u); ++i)
				{
					if (k < In[i] % 3)
					{
						Expected.push_back(i * 4 + k);
					}
				}
			}
		}
	}
	ForEachForm(
		Text, NumThreads, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Kept"].assign(NumThreads * 2 * 4, 77);
			H.Buffers["Kept@count"] = {0};
		},
		[&](FShaderHarness& H)
		{
			ASSERT_EQ(Expected.size(), H.Buffers["Kept@count"][0]);
			for (size_t i = 0; i < Expected.size(); ++i)
			{
				EXPECT_EQ(float(Expected[i] / 4), H.BufferFloat("Kept", i * 4)) << i;
				EXPECT_EQ(float(Expected[i] % 4), H.BufferFloat("Kept", i * 4 + 1)) << i;
				EXPECT_EQ(Expected[i], H.Buffers["Kept"][i * 4 + 3]) << i;
			}
			EXPECT_EQ(77u, H.Buffers["Kept"][Expected.size() * 4]);
		});
}

TEST(ShaderCounters, ConsumeTakesTheLastElementFirst)
{
	const std::string Text = R"(
ConsumeStructuredBuffer<uint2> In;
RWStructuredBuffer<uint2> Out;
[numthreads(40, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	Out[Id.x] = In.Consume();
}
)";
	std::vector<uint32_t> In(200);
	std::iota(In.begin(), In.end(), 1000u);
	ForEachForm(
		Text, 80, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["In@count"] = {90};
			H.Buffers["Out"].assign(160, 0);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(10u, H.Buffers["In@count"][0]);
			for (uint32_t i = 0; i < 80; ++i)
			{
				EXPECT_EQ(1000 + (89 - i) * 2, H.Buffers["Out"][i * 2]) << i;
				EXPECT_EQ(1001 + (89 - i) * 2, H.Buffers["Out"][i * 2 + 1]) << i;
			}
		});
}

TEST(ShaderCounters, IncrementGivesTheOldValueAndDecrementTheNewOne)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Out;
RWStructuredBuffer<float> Other;
[numthreads(8, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	uint Taken = Out.IncrementCounter();
	if (I % 2)
	{
		Out[Taken] = 100 + Out.DecrementCounter();
	}
	Other.DecrementCounter();
}
)";
	// Threads 0 to 7 take 0 to 7 together; then 1, 3, 5 and 7 give back 8, 7, 6 and 5, and see what remains.
	const std::vector<uint32_t> Expected = {0, 107, 0, 106, 0, 105, 0, 104};
	ForEachForm(
		Text, 8, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Out"].assign(8, 0);
			H.Buffers["Out@count"] = {0};
			H.Buffers["Other"] = {0};
			H.Buffers["Other@count"] = {3};
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(Expected, H.Buffers["Out"]);
			EXPECT_EQ(4u, H.Buffers["Out@count"][0]);
			EXPECT_EQ(3u - 8u, H.Buffers["Other@count"][0]);
		});
}

TEST(ShaderCounters, BeyondTheEndsTheCounterGoesOnAndNothingIsWritten)
{
	const std::string Text = R"(
AppendStructuredBuffer<uint> Kept;
ConsumeStructuredBuffer<uint> In;
RWStructuredBuffer<uint> Out;
[numthreads(16, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	Kept.Append(I + 1);
	Out[I] = In.Consume();
}
)";
	ForEachForm(
		Text, 16, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Kept"].assign(10, 0);
			H.Buffers["Kept@count"] = {0};
			H.Buffers["In"] = {5, 6, 7};
			H.Buffers["In@count"] = {3};
			H.Buffers["Out"].assign(16, 77);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ((std::vector<uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}), H.Buffers["Kept"]);
			EXPECT_EQ(16u, H.Buffers["Kept@count"][0]);
			EXPECT_EQ(3u - 16u, H.Buffers["In@count"][0]);
			EXPECT_EQ((std::vector<uint32_t>{7, 6, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), H.Buffers["Out"]);
		});
}

TEST(ShaderCounters, FunctionsTakeTheBuffers)
{
	const std::string Text = R"(
AppendStructuredBuffer<uint> Even, Odd;
void Put(AppendStructuredBuffer<uint> To, uint Value) { To.Append(Value); }
[numthreads(16, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	if (I % 2) Put(Odd, I); else Put(Even, I);
}
)";
	ForEachForm(
		Text, 16, 1, 1,
		[&](FShaderHarness& H)
		{
			for (const char* const Name : {"Even", "Odd"})
			{
				H.Buffers[Name].assign(8, 0);
				H.Buffers[std::string(Name) + "@count"] = {0};
			}
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ((std::vector<uint32_t>{0, 2, 4, 6, 8, 10, 12, 14}), H.Buffers["Even"]);
			EXPECT_EQ((std::vector<uint32_t>{1, 3, 5, 7, 9, 11, 13, 15}), H.Buffers["Odd"]);
			EXPECT_EQ(8u, H.Buffers["Odd@count"][0]);
		});
}

TEST(ShaderCounters, StructsVariablesAndArraysHoldTheBuffers)
{
	const std::string Text = R"(
AppendStructuredBuffer<uint> Kept;
AppendStructuredBuffer<uint> Bins[2];
struct FStreams { ConsumeStructuredBuffer<uint> From; RWStructuredBuffer<uint> Marks; };
FStreams Streams;
struct FTarget { uint Factor; AppendStructuredBuffer<uint> Items; };
[numthreads(8, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	FTarget Target;
	Target.Factor = 3;
	Target.Items = Kept;
	Target.Items.Append(I * Target.Factor);
	AppendStructuredBuffer<uint> Bin = Bins[I % 2];
	Bin.Append(Streams.From.Consume());
	Streams.Marks[Streams.Marks.IncrementCounter()] = I;
}
)";
	ForEachForm(
		Text, 8, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Kept"].assign(8, 0);
			H.Buffers["Bins_0"].assign(4, 0);
			H.Buffers["Bins_1"].assign(4, 0);
			H.Buffers["Streams_From"] = {10, 11, 12, 13, 14, 15, 16, 17};
			H.Buffers["Streams_From@count"] = {8};
			H.Buffers["Streams_Marks"].assign(8, 0);
			for (const char* const Name : {"Kept@count", "Bins_0@count", "Bins_1@count", "Streams_Marks@count"})
			{
				H.Buffers[Name] = {0};
			}
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ((std::vector<uint32_t>{0, 3, 6, 9, 12, 15, 18, 21}), H.Buffers["Kept"]);
			EXPECT_EQ((std::vector<uint32_t>{17, 15, 13, 11}), H.Buffers["Bins_0"]);
			EXPECT_EQ((std::vector<uint32_t>{16, 14, 12, 10}), H.Buffers["Bins_1"]);
			EXPECT_EQ((std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}), H.Buffers["Streams_Marks"]);
			EXPECT_EQ(0u, H.Buffers["Streams_From@count"][0]);
			EXPECT_EQ(4u, H.Buffers["Bins_1@count"][0]);
		});
}

TEST(ShaderCounters, ReflectionTellsWhoseCounterItIs)
{
	FShaderHarness Harness(R"(
AppendStructuredBuffer<uint> A : register(u0), B : register(u1);
ConsumeStructuredBuffer<uint> C;
RWStructuredBuffer<uint> D;
[numthreads(1, 1, 1)] void MainCS() { B.Append(C.Consume()); D[0] = D.IncrementCounter(); }
)",
		"MainCS", EShaderStage::Compute);
	std::map<std::string, EShaderCounter> Counters;
	const FShaderReflection Reflection = ReflectShader(Harness.Request);
	for (const FShaderResource& Resource : Reflection.RWBuffers)
	{
		if (!Resource.CounterOf.empty())
		{
			Counters[Resource.CounterOf] = Resource.Counter;
		}
	}
	EXPECT_EQ((std::map<std::string, EShaderCounter>{
				  {"B", EShaderCounter::Append}, {"C", EShaderCounter::Append}, {"D", EShaderCounter::Atomic}}),
		Counters);
	EXPECT_TRUE(Reflection.bGroupsInOrder);
}

TEST(ShaderCounters, GroupsRunSideBySideWhereNobodyLooksAtTheCount)
{
	FShaderHarness Harness(R"(
RWStructuredBuffer<uint> Out;
[numthreads(64, 1, 1)] void MainCS() { Out.IncrementCounter(); }
)",
		"MainCS", EShaderStage::Compute);
	EXPECT_FALSE(ReflectShader(Harness.Request).bGroupsInOrder);
}

TEST(ShaderCounters, WhatABufferHasNoMethodForIsSaidWithItsLine)
{
	const std::string Buffers = "AppendStructuredBuffer<uint> Kept;\nConsumeStructuredBuffer<uint> In;\n"
								"RWStructuredBuffer<uint> Out;\nRWByteAddressBuffer Bytes;";
	EXPECT_THAT(ErrorOfShader(Buffers, "Out[0] = Kept.Consume();"),
		HasSubstr(
			"/Test/Shader.usf:8:15: error: X3018: AppendStructuredBuffer<uint> has no method 'Consume', which is of "
			"ConsumeStructuredBuffer"));
	EXPECT_THAT(ErrorOfShader(Buffers, "In.Append(1);"),
		HasSubstr("ConsumeStructuredBuffer<uint> has no method 'Append', which is of AppendStructuredBuffer"));
	EXPECT_THAT(ErrorOfShader(Buffers, "Out.Append(1);"),
		HasSubstr("RWStructuredBuffer<uint> has no method 'Append', which is of AppendStructuredBuffer"));
	EXPECT_THAT(ErrorOfShader(Buffers, "Kept.IncrementCounter();"),
		HasSubstr("AppendStructuredBuffer<uint> has no method 'IncrementCounter', which is of RWStructuredBuffer"));
	EXPECT_THAT(ErrorOfShader(Buffers, "Out[0] = Kept[1];"),
		HasSubstr("'AppendStructuredBuffer<uint>' cannot be indexed; write Append(Value)"));
	EXPECT_THAT(ErrorOfShader(Buffers, "In[0] = 1;"),
		HasSubstr("'ConsumeStructuredBuffer<uint>' cannot be indexed; write Consume()"));
	EXPECT_THAT(ErrorOfShader(Buffers, "Out[0] = Bytes.IncrementCounter();"),
		HasSubstr("RWByteAddressBuffer has no method 'IncrementCounter', which is of RWStructuredBuffer"));
}
